#include "pixel_lists.h"

#include "render/raster_side.h"
#include "slice/gpu_records.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::render::test
{

namespace
{

using vp::shared::PolygonRecord;

double uniform(std::mt19937& random, double from, double to)
{
	return std::uniform_real_distribution<double>(from, to)(random);
}

// A polygon of a mesh: its corners' numbers.
using Corners = std::vector<std::uint32_t>;

// Without holes or laps: quadrangles with corners out of place, some cut along a diagonal, some with a corner more
// within a side.
struct Mesh
{
	std::vector<glm::dvec2> points;
	std::vector<Corners> polygons;

	Mesh(std::mt19937& random, int side, double half, bool bends = true)
	{
		const double step = 2.0 * half / side;
		for (int j = 0; j <= side; ++j)
			for (int i = 0; i <= side; ++i)
				points.push_back(step * glm::dvec2(i, j) - half +
				                 step * glm::dvec2(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2)));
		for (int j = 0; j < side; ++j)
			for (int i = 0; i < side; ++i)
				addCell(random, static_cast<std::uint32_t>(j * (side + 1) + i), static_cast<std::uint32_t>(side + 1),
				        bends ? 3 : 2);
	}

	PolygonRecord record(std::size_t polygon, double value) const
	{
		PolygonRecord made{};
		for (const std::uint32_t corner : polygons[polygon])
		{
			made.uv[2 * made.vertices] = static_cast<float>(points[corner].x);
			made.uv[2 * made.vertices + 1] = static_cast<float>(points[corner].y);
			made.value[made.vertices++] = static_cast<float>(value + 0.3 * std::sin(points[corner].x));
		}
		return made;
	}

private:
	void addCell(std::mt19937& random, std::uint32_t a, std::uint32_t row, unsigned kinds)
	{
		const std::uint32_t b = a + 1;
		const std::uint32_t c = a + row + 1;
		const std::uint32_t d = a + row;
		switch (random() % kinds)
		{
		case 0:
			polygons.push_back({a, b, c, d});
			break;
		case 1:
			polygons.push_back({a, b, c});
			polygons.push_back({c, d, a});
			break;
		default:
			// A corner on the diagonal, which rounding puts on one side of it or the other.
			points.push_back(glm::mix(points[a], points[c], uniform(random, 0.1, 0.9)));
			polygons.push_back({a, b, c, static_cast<std::uint32_t>(points.size() - 1)});
			polygons.push_back({c, d, a, static_cast<std::uint32_t>(points.size() - 1)});
		}
	}
};

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
		auto made = Renderer::create(device(), kMostFragmentBytes, side);
		EXPECT_TRUE(made);
		return std::move(*made);
	}

	// A picture of some of a mesh's polygons, opaque on nothing, with values from 0 to 1.
	Scene sceneOf(const View& view, const std::vector<PolygonRecord>& records)
	{
		Scene scene = bareScene(203, 151, 1);
		scene.look.background = parseBackground("transparent").value();
		auto on_device = slice::recordsFromHost(pool(), records);
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

	const std::shared_ptr<slice::RecordPool>& pool()
	{
		if (!pool_)
			pool_ = slice::RecordPool::create(device(), 4096);
		return pool_;
	}

private:
	std::shared_ptr<slice::RecordPool> pool_;
};

// Polygons are parted in two by each bit of their number. If the halves cover every pixel once, then so do all
// polygons: any two of them differ in some bit.
TEST_F(Raster, EveryPixelBelongsToOnePolygon)
{
	std::mt19937 random(71);
	// Polygons of about 20, 7 and 2 pixels; all by the compute shader, then shared with the hardware at various
	// sizes.
	for (const int cells : {36, 100, 300})
		for (const std::uint32_t side : {64u, 8u, 2u})
		{
			Renderer renderer = rendererOf(side);
			// Of a polygon that snapping bends inwards the hardware's triangles cover more.
			const Mesh mesh(random, cells, 4.5, side == 64);
			const View view = obliqueView(random);
			std::vector<PolygonRecord> all;
			for (std::size_t p = 0; p < mesh.polygons.size(); ++p)
				all.push_back(mesh.record(p, 0.5));
			const std::vector<bool> whole = coverage(renderer, view, all);
			EXPECT_EQ(std::ranges::count(whole, false), 0) << cells << " cells, side " << side;
			for (std::size_t bit = 1; bit < all.size(); bit *= 2)
			{
				std::vector<PolygonRecord> halves[2];
				for (std::size_t p = 0; p < all.size(); ++p)
					halves[(p & bit) != 0].push_back(all[p]);
				const std::vector<bool> first = coverage(renderer, view, halves[0]);
				const std::vector<bool> second = coverage(renderer, view, halves[1]);
				std::size_t wrong = 0;
				for (std::size_t i = 0; i < first.size(); ++i)
					wrong += first[i] == second[i];
				EXPECT_EQ(wrong, 0u) << cells << " cells, side " << side << ", bit " << bit;
			}
		}
}

// What the compute shader draws is what the hardware draws but for pixels that lie on an edge.
TEST_F(Raster, BothWaysAgreeOnRandomProbes)
{
	Renderer hardware = rendererOf(0);
	Renderer compute = rendererOf(64);
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
			auto records = slice::recordsFromHost(pool(), known.records);
			ASSERT_TRUE(records);
			scene.sheets.push_back(known.drawing);
			scene.sheets.back().records = *records;
		}
		scene.camera = randomCamera(random);
		const auto a = hardware.draw(scene);
		const auto b = compute.draw(scene);
		ASSERT_TRUE(a && b);
		const std::vector<PixelList> lists = blendedLists(scene, sheets);
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
	EXPECT_LE(2'000 * edges_off, pixels);
}

TEST_F(Raster, BothWaysAgreeWhereTheEyeIsInTheSheet)
{
	Renderer hardware = rendererOf(0);
	Renderer compute = rendererOf(64);
	std::mt19937 random(9);
	for (int i = 0; i < 6; ++i)
	{
		const Mesh mesh(random, 60, 1.0);
		const View view = grazingView(random);
		std::vector<PolygonRecord> records;
		for (std::size_t p = 0; p < mesh.polygons.size(); ++p)
			records.push_back(mesh.record(p, 0.5));
		const Scene scene = sceneOf(view, records);
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
		EXPECT_LE(1'000 * off, covered) << i; // where an edge of the sheet passes through a pixel's centre
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
	const Mesh mesh(random, 90, 2.0);
	std::vector<PolygonRecord> records;
	for (std::size_t p = 0; p < mesh.polygons.size(); ++p)
	{
		records.push_back(mesh.record(p, 0.0));
		std::fill(std::begin(records.back().value), std::end(records.back().value), 0.5f);
	}
	auto on_device = slice::recordsFromHost(pool(), records);
	ASSERT_TRUE(on_device);
	scene.sheets.push_back({obliqueView(random).sheet, *on_device, 1.0});
	scene.sheets[0].sheet = probe::makeSheet({0.0, 0.0, 0.0}, {0.1, 0.2, 1.0});
	auto drawn = rendererOf(64).draw(scene);
	ASSERT_TRUE(drawn);
	const auto middle = drawn->pixel(80, 60);
	for (std::uint32_t y = 40; y < 80; ++y)
		for (std::uint32_t x = 50; x < 110; ++x)
			EXPECT_EQ(drawn->pixel(x, y), middle) << x << " " << y;
}

} // namespace vp::render::test
