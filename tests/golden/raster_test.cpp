#include "pixel_lists.h"
#include "tiling.h"
#include "tries.h"
#include "uniform.h"

#include "classify/gpu_records.h"
#include "render/passes/raster_side.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::render::test
{

namespace
{

using vp::shared::PolygonRecord;

struct View
{
	probe::Sheet sheet;
	Camera camera;
};

// The sheet fills the picture, seen obliquely.
View obliqueView(std::mt19937& random)
{
	View view;
	const double tilt = uniform(random, 0.0, 0.9);
	const double turn = uniform(random, 0.0, 2.0 * std::numbers::pi);
	view.sheet = probe::makeSheet({0.0, 0.0, 0.0},
	                              {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)});
	view.camera.position = {0.0, 0.0, 5.0};
	view.camera.vertical_field = 20.0;
	view.camera.near = 1.0;
	return view;
}

// The eye is close above the sheet, and within it: polygons reach from before the near plane to far away.
View grazingView(std::mt19937& random)
{
	View view;
	view.sheet = probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 1.0, uniform(random, -0.05, 0.05)});
	view.camera.position = {0.1, uniform(random, 0.02, 0.3), 0.2};
	view.camera.focal_point = {0.0, -0.1, -1.0};
	view.camera.vertical_field = 60.0;
	view.camera.near = 1e-3;
	return view;
}

} // namespace

class Raster : public DrawingTest
{
protected:
	Renderer rendererOf(std::uint32_t side)
	{
		auto made = Renderer::create(device(), kMaxFragmentBytes, side);
		EXPECT_TRUE(made);
		return std::move(*made);
	}

	// A picture of some of a mesh's polygons, opaque on nothing, with values from 0 to 1.
	Scene sceneOf(const View& view, const std::vector<PolygonRecord>& records)
	{
		Scene scene = bareScene(203, 151, 1);
		scene.look.background = parseBackground("transparent").value();
		auto on_device = classify::recordsFromHost(pool(), records);
		EXPECT_TRUE(on_device);
		scene.sheets.push_back({view.sheet, *on_device, 1.0});
		scene.camera = view.camera;
		return scene;
	}

	std::vector<bool> coverage(Renderer& renderer, const View& view, const std::vector<PolygonRecord>& records)
	{
		auto drawn = renderer.draw(sceneOf(view, records));
		EXPECT_TRUE(drawn);
		std::vector<bool> covered;
		for (std::size_t i = 3; i < drawn->rgba.size(); i += 4)
			covered.push_back(drawn->rgba[i] > 0);
		return covered;
	}

	// Parts the polygons in two by each bit of their number. Each pixel that all of them cover must be covered by one
	// half and not by the other: any two polygons differ in some bit. Returns what all cover.
	std::vector<bool> expectOneOwner(std::uint32_t side, const View& view, const std::vector<PolygonRecord>& all)
	{
		Renderer renderer = rendererOf(side);
		const std::vector<bool> whole = coverage(renderer, view, all);
		for (std::size_t bit = 1; bit < all.size(); bit *= 2)
		{
			std::vector<PolygonRecord> halves[2];
			for (std::size_t p = 0; p < all.size(); ++p)
				halves[(p & bit) != 0].push_back(all[p]);
			const std::vector<bool> first = coverage(renderer, view, halves[0]);
			const std::vector<bool> second = coverage(renderer, view, halves[1]);
			std::size_t wrong = 0;
			for (std::size_t i = 0; i < first.size(); ++i)
				wrong += whole[i] ? first[i] == second[i] : first[i] || second[i];
			EXPECT_EQ(wrong, 0u) << "bit " << bit;
		}
		return whole;
	}

	const std::shared_ptr<classify::RecordPool>& pool()
	{
		if (!pool_)
			pool_ = classify::RecordPool::create(device(), 4096);
		return pool_;
	}

private:
	std::shared_ptr<classify::RecordPool> pool_;
};

// Polygons of about 20, 7 and 2 pixels, in every share of the stages.
TEST_F(Raster, EveryPixelBelongsToOnePolygon)
{
	std::mt19937 random(71);
	vp::test::Taken taken;
	for (const int cells : {36, 100, 300})
		for (const std::uint32_t side : {64u, 8u, 2u})
		{
			if (!taken.next())
				continue;
			SCOPED_TRACE(fmt::format("{} cells, side {}", cells, side));
			const View view = obliqueView(random);
			const std::vector<bool> whole = expectOneOwner(side, view, Tiling(random, cells, 4.5, true).records());
			EXPECT_EQ(std::ranges::count(whole, false), 0);
		}
}

// From a thousandth of a pixel to more than the picture.
TEST_F(Raster, SoDoPolygonsOfAnySize)
{
	std::mt19937 random(72);
	const View facing = obliqueView(random);
	for (const int cells : {1, 2, 5, 12})
	{
		SCOPED_TRACE(cells);
		const std::vector<bool> whole = expectOneOwner(16, facing, Tiling(random, cells, 9.0, true).records());
		EXPECT_EQ(std::ranges::count(whole, false), 0);
	}
	for (const double half : {0.006, 0.05})
	{
		SCOPED_TRACE(half);
		const std::vector<bool> whole = expectOneOwner(16, facing, Tiling(random, 300, half, true).records());
		EXPECT_TRUE(whole[75 * 203 + 101]) << "the middle";
	}
}

TEST_F(Raster, SoDoSlivers)
{
	std::mt19937 random(73);
	vp::test::Taken taken;
	for (const glm::ivec2& sides : {glm::ivec2(2, 2000), {2000, 2}, {7, 400}, {1500, 20}})
	{
		if (!taken.next())
			continue;
		SCOPED_TRACE(fmt::format("{} x {}", sides.x, sides.y));
		const View view = obliqueView(random);
		const std::vector<bool> whole = expectOneOwner(16, view, Tiling(random, sides, 9.0, true).records());
		EXPECT_EQ(std::ranges::count(whole, false), 0);
	}
}

// Polygons that reach the near plane, and out of all bounds.
TEST_F(Raster, SoDoThoseAboutTheEye)
{
	std::mt19937 random(74);
	vp::test::Taken taken;
	for (const int cells : {2, 9, 40})
		for (int i = 0; i < 2; ++i)
		{
			if (!taken.next())
				continue;
			SCOPED_TRACE(cells);
			const View view = grazingView(random);
			const std::vector<bool> whole = expectOneOwner(16, view, Tiling(random, cells, 30.0, true).records());
			EXPECT_GT(std::ranges::count(whole, true), 5'000);
		}
}

// The compute shader draws the same as the hardware, except for pixels on an edge.
TEST_F(Raster, BothWaysAgreeOnRandomProbes)
{
	Renderer hardware = rendererOf(0);
	Renderer compute = rendererOf(64);
	const double reach = edgeReach(device().limits().subPixelPrecisionBits);
	std::size_t pixels = 0;
	std::size_t edges_off = 0;
	for (unsigned seed = 0; seed < 12; ++seed)
	{
		std::mt19937 random(500 + seed);
		const std::vector<KnownSheet> sheets = randomProbe(random);
		Scene scene = bareScene(200, 150, seed % 4 == 2 ? 3 : 1);
		scene.look.lines = seed % 4 == 0 ? 5 : 0;
		scene.look.bands = seed % 4 == 1 ? 6 : 0;
		for (const KnownSheet& known : sheets)
		{
			auto records = classify::recordsFromHost(pool(), known.records);
			ASSERT_TRUE(records);
			scene.sheets.push_back(known.drawing);
			scene.sheets.back().records = *records;
		}
		scene.camera = randomCamera(random);
		const auto a = hardware.draw(scene);
		const auto b = compute.draw(scene);
		ASSERT_TRUE(a && b);
		const std::vector<PixelList> lists = blendedLists(scene, sheets, {}, reach);
		for (std::size_t i = 0; i < lists.size(); ++i)
		{
			const std::uint8_t* p = &b->rgba[4 * i];
			const std::uint8_t* q = &a->rgba[4 * i];
			const bool off = difference({double(q[0]), double(q[1]), double(q[2])}, {p[0], p[1], p[2], p[3]}) > 2.0;
			++pixels;
			edges_off += off;
			// Elsewhere lines and bands may begin a pixel earlier, and edges are those of samples.
			if (seed % 4 == 3)
			{
				EXPECT_TRUE(!off || lists[i].on_edge) << "seed " << seed << ", pixel " << i;
			}
		}
	}
	EXPECT_LE(2'000 * edges_off, reach / kEdgeReach * pixels);
}

TEST_F(Raster, BothWaysAgreeWhereTheEyeIsInTheSheet)
{
	Renderer hardware = rendererOf(0);
	Renderer compute = rendererOf(64);
	std::mt19937 random(9);
	for (int i = 0; i < 6; ++i)
	{
		const Scene scene = sceneOf(grazingView(random), Tiling(random, 60, 1.0, true).records());
		const auto a = hardware.draw(scene);
		const auto b = compute.draw(scene);
		ASSERT_TRUE(a && b);
		std::size_t covered = 0;
		std::size_t off = 0;
		for (std::size_t p = 0; p < a->rgba.size(); p += 4)
		{
			covered += a->rgba[p + 3] > 0;
			for (std::size_t c = p; c < p + 4; ++c)
				if (std::abs(a->rgba[c] - b->rgba[c]) > 2)
				{
					++off;
					break;
				}
		}
		EXPECT_GT(covered, 5'000u);
		EXPECT_LE(1'000 * off, covered) << i; // where an edge of the sheet passes through a pixel's center
	}
}

// Blocks that lie on each other, as overset grids do: the later one is seen, in whatever order threads run.
TEST_F(Raster, LaterPartsCoverEarlierOnes)
{
	std::mt19937 random(17);
	std::vector<PolygonRecord> records;
	std::vector<std::size_t> parts;
	for (const auto& [half, value] : {std::pair{1.5, 0.2f}, {0.9, 0.9f}, {1.2, 0.5f}, {0.4, 0.7f}})
	{
		if (!records.empty())
			parts.push_back(records.size());
		for (PolygonRecord record : Tiling(random, 80, half, true).records())
		{
			std::fill(std::begin(record.value), std::end(record.value), value);
			records.push_back(record);
		}
	}
	Scene scene = bareScene(200, 150, 1);
	scene.camera.vertical_field = 35.0;
	for (const bool computed : {false, true})
	{
		auto on_device = classify::recordsFromHost(pool(), records); // several pages
		ASSERT_TRUE(on_device);
		(*on_device)->overlapping = !computed;
		(*on_device)->parts = computed ? parts : std::vector<std::size_t>();
		scene.sheets.assign(1, {probe::makeSheet({0.0, 0.0, 0.0}, {0.1, 0.2, 1.0}), *on_device, 1.0});
		auto drawn = rendererOf(16).draw(scene);
		ASSERT_TRUE(drawn);
		const auto colorOf = [&](double value) { return rgb(scene.look.colors.at(value)); };
		EXPECT_LE(difference(colorOf(0.7), drawn->pixel(100, 75)), 1.0);
		EXPECT_LE(difference(colorOf(0.5), drawn->pixel(100, 45)), 1.0) << "between, and over the second";
		EXPECT_LE(difference(colorOf(0.2), drawn->pixel(100, 9)), 1.0);
		for (int again = 0; again < 3; ++again)
			EXPECT_TRUE(rendererOf(16).draw(scene)->rgba == drawn->rgba);
	}
}

TEST_F(Raster, TheFasterWayIsMeasured)
{
	const auto side = measuredRasterSide(device());
	ASSERT_TRUE(side);
	EXPECT_TRUE(*side == 0 || *side == kRasterSide);
}

TEST_F(Raster, PolygonsWithoutOneValueHaveTheirColor)
{
	Scene scene = bareScene(96, 64, 1);
	constexpr double kInfinite = std::numeric_limits<double>::infinity();
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	const auto f = [=](double u, double v)
	{ return u < 0.0 ? (v < 0.0 ? kNan : 0.25) : (v < 0.0 ? kInfinite : -kInfinite); };
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 1.5, 1.0, f, 64));
	Renderer hardware = rendererOf(0);
	Renderer compute = rendererOf(64);
	const auto a = hardware.draw(scene);
	const auto b = compute.draw(scene);
	ASSERT_TRUE(a && b);
	EXPECT_EQ(a->rgba, b->rgba);
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.25)), b->pixel(40, 20)), 1.0);
	EXPECT_LE(difference(rgb(scene.look.colors.nan), b->pixel(40, 50)), 1.0);
}

TEST_F(Raster, CellValuesStayWhatTheyAre)
{
	// Values on the bounds of bands: the least rounding would show as specks.
	Scene scene = bareScene(160, 120, 1);
	scene.look.bands = 10;
	std::mt19937 random(4);
	std::vector<PolygonRecord> records = Tiling(random, 90, 2.0, true).records();
	for (PolygonRecord& record : records)
		std::fill(std::begin(record.value), std::end(record.value), 0.5f);
	auto on_device = classify::recordsFromHost(pool(), records);
	ASSERT_TRUE(on_device);
	scene.sheets.push_back({probe::makeSheet({0.0, 0.0, 0.0}, {0.1, 0.2, 1.0}), *on_device, 1.0});
	auto drawn = rendererOf(64).draw(scene);
	ASSERT_TRUE(drawn);
	const auto middle = drawn->pixel(80, 60);
	for (std::uint32_t y = 40; y < 80; ++y)
		for (std::uint32_t x = 50; x < 110; ++x)
			EXPECT_EQ(drawn->pixel(x, y), middle) << x << " " << y;
}

} // namespace vp::render::test
