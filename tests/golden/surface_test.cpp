#include "known_surface.h"

#include "render/passes/surface_polygons.h"
#include "shared/render_types.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vp::render::test
{

namespace
{

constexpr Color kOrange{240, 140, 20};

// A unit sphere of quadrangles that are not flat, closed.
mesh::SheetMesh sphere(int around = 24)
{
	mesh::SheetMesh mesh;
	const int down = around / 2;
	const auto at = [&](int i, int j)
	{
		const double longitude = 2.0 * std::numbers::pi * (i % around) / around;
		const double latitude = std::numbers::pi * (static_cast<double>(j) / down - 0.5);
		const double ring = j == 0 || j == down ? 0.0 : std::cos(latitude);
		return Vec3(ring * std::cos(longitude), ring * std::sin(longitude), std::sin(latitude));
	};
	for (int j = 0; j < down; ++j)
		for (int i = 0; i < around; ++i)
		{
			std::vector<Vec3> corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
			corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
			addPolygon(mesh, corners);
		}
	return mesh;
}

class SurfaceLook : public DrawingTest
{
protected:
	Surface surface(const mesh::SheetMesh& mesh, const SurfaceValues& values = {})
	{
		auto polygons = surfacePolygons(device(), mesh, values);
		EXPECT_TRUE(polygons);
		Surface made;
		made.polygons = *polygons;
		made.color = kOrange;
		made.lit = false;
		return made;
	}

	// A square about the origin across the view, of n by n polygons, with values x at the vertices.
	Surface square(int n, double opacity, bool of_polygons = false)
	{
		mesh::SheetMesh mesh;
		std::vector<double> polygon_values;
		for (int j = 0; j < n; ++j)
			for (int i = 0; i < n; ++i)
			{
				const auto at = [n](int k) { return 2.8 * k / n - 1.4; };
				addPolygon(mesh, {{at(i), at(j), 0.0},
				                  {at(i + 1), at(j), 0.0},
				                  {at(i + 1), at(j + 1), 0.0},
				                  {at(i), at(j + 1), 0.0}});
				polygon_values.push_back((i + 0.5) / n);
			}
		std::vector<double> vertex_values;
		for (const Vec3& p : mesh.positions)
			vertex_values.push_back(p.x / 2.8 + 0.5);
		Surface made = of_polygons ? surface(mesh, {{}, polygon_values}) : surface(mesh, {vertex_values, {}});
		made.values = ValueScale{.title = "f", .per_cell = of_polygons};
		made.opacity = opacity;
		return made;
	}
};

const auto kAcross = [](double u, double) { return u / 2.8 + 0.5; };

} // namespace

TEST_F(SurfaceLook, AClosedOneIsThereTwiceAtEachPixel)
{
	Scene scene = bareScene(150, 120, 1);
	scene.camera.position = {3.1, -2.3, 2.7};
	scene.camera.up = {0.0, 0.0, 1.0};
	scene.surfaces.push_back(surface(sphere()));
	scene.surfaces[0].opacity = 0.5;
	const Picture picture = draw(scene);
	const Rgb twice = over(rgb(kOrange), 0.5, over(rgb(kOrange), 0.5, kWhite));
	std::size_t inside = 0;
	for (std::uint32_t y = 0; y < 120; ++y)
		for (std::uint32_t x = 0; x < 150; ++x)
		{
			const double off = difference(twice, picture.pixel(x, y));
			inside += off <= 1.0;
			ASSERT_TRUE(off <= 1.0 || difference(kWhite, picture.pixel(x, y)) == 0.0) << x << " " << y;
		}
	EXPECT_GE(inside, 2000u);
	EXPECT_LE(inside, 10000u);
}

TEST_F(SurfaceLook, AnOpaqueOneHidesWhatIsBehind)
{
	Scene scene = bareScene(120, 90, 1);
	scene.surfaces.push_back(surface(sphere()));
	scene.sheets.push_back(DrawingTest::square(probe::makeSheet({0.0, 0.0, -1.5}, {0.0, 0.0, 1.0}), 1.2, 1.0, kAcross));
	const auto behind = draw(scene).pixel(60, 45);
	EXPECT_LE(difference(rgb(kOrange), behind), 1.0);
	scene.sheets[0].sheet.origin.z = 1.5;
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.5)), draw(scene).pixel(60, 45)), 2.0);
}

// Its later samples are made of the triangles near edges alone. Lists of fragments are made of them all.
TEST_F(SurfaceLook, AnOpaqueOneOfManyTrianglesHasAllItsSamples)
{
	Scene scene = bareScene(300, 220, 8);
	scene.camera.position = {3.1, -2.3, 2.7};
	scene.camera.up = {0.0, 0.0, 1.0};
	for (const double place : {-0.3, 0.45})
	{
		mesh::SheetMesh mesh = sphere(60);
		for (Vec3& position : mesh.positions)
			position = {0.7 * position.x + place, 0.7 * position.y, position.z};
		scene.surfaces.push_back(surface(mesh));
		scene.surfaces.back().lit = true;
	}
	scene.surfaces[1].color = {30, 60, 200};
	scene.surfaces[1].mesh = true;
	const Picture opaque = draw(scene);
	EXPECT_TRUE(draw(scene).rgba == opaque.rgba);
	for (Surface& each : scene.surfaces)
		each.opacity = 0.999999;
	const Picture listed = draw(scene);
	std::size_t off = 0;
	std::size_t there = 0;
	for (std::uint32_t y = 0; y < 220; ++y)
		for (std::uint32_t x = 0; x < 300; ++x)
		{
			const auto [r, g, b, a] = listed.pixel(x, y);
			off += difference(rgb(Color{r, g, b, a}), opaque.pixel(x, y)) > 2.0;
			there += difference(kWhite, opaque.pixel(x, y)) > 0.0;
		}
	EXPECT_GE(there, 10000u);
	EXPECT_LE(1000 * off, there) << off << " of " << there;
}

TEST_F(SurfaceLook, SamplesAndTransparentBackgroundAsForALayer)
{
	Scene as_layer = bareScene(160, 120, 8);
	as_layer.look.background = parseBackground("transparent").value();
	Scene as_surface = as_layer;
	as_layer.sheets.push_back(DrawingTest::square(probe::makeSheet(Vec3(0.0), {0.0, 0.0, 1.0}), 1.4, 0.6, kAcross));
	as_layer.sheets[0].rim = false;
	as_surface.surfaces.push_back(square(8, 0.6));
	const Picture one = draw(as_layer);
	const Picture other = draw(as_surface);
	std::size_t half_there = 0;
	for (std::size_t i = 0; i < one.rgba.size(); ++i)
	{
		// If alpha is small, dividing by it magnifies rounding errors.
		const double alpha = one.rgba[i | 3] / 255.0;
		ASSERT_NEAR(one.rgba[i], other.rgba[i], 2.0 / std::max(alpha, 0.01)) << i;
		half_there += i % 4 == 3 && one.rgba[i] > 10 && one.rgba[i] < 140;
	}
	EXPECT_GE(half_there, 200u); // smooth edges
}

TEST_F(SurfaceLook, LinesBandsLogarithmAndMeshAsOfALayer)
{
	for (const char* what : {"lines", "bands", "log", "mesh"})
	{
		Scene as_layer = bareScene(160, 120, 4);
		as_layer.look.lines = what == std::string("lines") ? 6 : 0;
		as_layer.look.bands = what == std::string("bands") ? 6 : 0;
		as_layer.look.logarithmic = what == std::string("log");
		as_layer.look.mesh = what == std::string("mesh");
		as_layer.values->log_lo = 0.01;
		Scene as_surface = as_layer;
		as_layer.sheets.push_back(DrawingTest::square(probe::makeSheet(Vec3(0.0), {0.0, 0.0, 1.0}), 1.4, 0.8, kAcross));
		as_surface.surfaces.push_back(square(8, 0.8));
		as_surface.surfaces[0].mesh = as_layer.look.mesh;
		as_surface.surfaces[0].values->log_lo = 0.01;
		const Picture one = draw(as_layer);
		const Picture other = draw(as_surface);
		as_surface.look.lines = as_surface.look.bands = 0;
		as_surface.look.logarithmic = as_surface.surfaces[0].mesh = false;
		const Picture plain = draw(as_surface);
		std::size_t off = 0;
		std::size_t marked = 0;
		for (std::size_t i = 0; i < one.rgba.size(); ++i)
		{
			off += std::abs(one.rgba[i] - other.rgba[i]) > 6;
			marked += std::abs(other.rgba[i] - plain.rgba[i]) > 10;
		}
		EXPECT_LE(off, 40u) << what;
		EXPECT_GE(marked, 1000u) << what;
	}
}

TEST_F(SurfaceLook, ValuesOfPolygonsAndNan)
{
	Scene scene = bareScene(160, 120, 1);
	scene.surfaces.push_back(square(2, 1.0, true));
	const Picture picture = draw(scene);
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.25)), picture.pixel(60, 50)), 1.0);
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.75)), picture.pixel(100, 50)), 1.0);

	mesh::SheetMesh mesh;
	addPolygon(mesh, {{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}, {-1.0, 1.0, 0.0}});
	const std::vector<double> values{0.0, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0};
	scene.surfaces[0] = surface(mesh, {values, {}});
	scene.surfaces[0].values = ValueScale{.title = "f", .has_nan = true};
	// Everywhere, on both sides of the diagonal.
	const Picture unknown = draw(scene);
	EXPECT_LE(difference(rgb(scene.look.colors.nan), unknown.pixel(70, 50)), 1.0);
	EXPECT_LE(difference(rgb(scene.look.colors.nan), unknown.pixel(90, 70)), 1.0);
}

TEST_F(SurfaceLook, LinesBetweenPolygons)
{
	Scene scene = bareScene(160, 120, 1);
	scene.surfaces.push_back(square(8, 1.0, true));
	const Picture plain = draw(scene);
	scene.surfaces[0].lines = 3; // at 0.25, 0.5 and 0.75, between every second pair of columns
	const Picture lined = draw(scene);
	const auto column = [&](double x)
	{ return 80.0 + x * (0.5 * 120 / std::tan(20.0 * std::numbers::pi / 180.0) / 5.0); };
	for (int k = 1; k < 8; ++k)
	{
		const auto x = static_cast<std::uint32_t>(column(2.8 * k / 8 - 1.4));
		const auto there = lined.pixel(x, 50);
		const auto before = plain.pixel(x, 50);
		const double off = difference({double(before[0]), double(before[1]), double(before[2])}, there);
		EXPECT_EQ(off > 30.0, k % 2 == 0) << k;
		EXPECT_EQ(lined.pixel(x + 6, 50), plain.pixel(x + 6, 50)) << k;
	}
}

TEST_F(SurfaceLook, ATurnedFaceIsDarkerAndAThickOneDenser)
{
	Scene scene = bareScene(200, 160, 1);
	scene.surfaces.push_back(surface(sphere(48)));
	scene.surfaces[0].lit = true;
	const Picture lit = draw(scene);
	// The light comes from the upper left, and the sphere is smooth: brightness falls along a row, with no step.
	EXPECT_GE(lit.pixel(80, 60)[0], lit.pixel(130, 110)[0] + 30);
	for (std::uint32_t x = 75; x < 125; ++x)
		EXPECT_NEAR(lit.pixel(x, 80)[0], lit.pixel(x + 1, 80)[0], 6) << x;

	scene.surfaces[0].lit = false;
	scene.surfaces[0].opacity = 0.2;
	scene.surfaces[0].thick = true;
	const Picture thick = draw(scene);
	const Rgb center = over(rgb(kOrange), 0.2, over(rgb(kOrange), 0.2, kWhite));
	EXPECT_LE(difference(center, thick.pixel(100, 80)), 2.0);
	std::uint32_t x = 100;
	while (difference(kWhite, thick.pixel(x + 1, 80)) > 0.0)
		++x;
	EXPECT_LE(thick.pixel(x, 80)[2] + 60, thick.pixel(100, 80)[2]);
}

TEST_F(SurfaceLook, LittleRoomForFragmentsGivesTheSamePicture)
{
	Scene scene = bareScene(150, 121, 2);
	for (int i = 0; i < 4; ++i)
	{
		scene.surfaces.push_back(surface(sphere()));
		scene.surfaces.back().opacity = 0.3;
		scene.surfaces.back().color.g = static_cast<std::uint8_t>(40 * i);
	}
	const Picture picture = draw(scene);
	// Room for a row and a half in the middle of the picture, where some 100 pixels have 8 fragments each.
	for (const std::uint64_t fragments : {20'000u, 3'000u, 1'200u})
	{
		auto little = Renderer::create(device(), 16 * fragments);
		ASSERT_TRUE(little);
		for (int again = 0; again < 2; ++again)
		{
			auto drawn = little->draw(scene);
			ASSERT_TRUE(drawn) << drawn.error().message;
			EXPECT_TRUE(drawn->rgba == picture.rgba) << fragments;
		}
	}
	auto none = Renderer::create(device(), 16 * 100);
	ASSERT_TRUE(none);
	const auto refused = none->draw(scene);
	ASSERT_FALSE(refused);
	EXPECT_NE(refused.error().message.find("`size`"), std::string::npos) << refused.error().message;
}

TEST_F(SurfaceLook, AFilmOfGrowingScenes)
{
	// The room made for one picture serves those after it, of other sizes too.
	for (const std::uint32_t width : {60u, 200u, 100u})
	{
		Scene scene = bareScene(width, 90, 1);
		const Picture without = draw(scene);
		for (int i = 0; i < 6; ++i)
			scene.surfaces.push_back(surface(sphere()));
		EXPECT_LE(difference(rgb(kOrange), draw(scene).pixel(width / 2, 45)), 1.0);
		scene.surfaces.clear();
		EXPECT_TRUE(draw(scene).rgba == without.rgba);
	}
}

TEST_F(SurfaceLook, TooManyAreRefused)
{
	Scene scene = bareScene(64, 48, 1);
	scene.surfaces.resize(vp::shared::kMaxSurfaces);
	EXPECT_TRUE(renderer().draw(scene)); // draws nothing
	scene.surfaces.resize(vp::shared::kMaxSurfaces + 1);
	const auto drawn = renderer().draw(scene);
	ASSERT_FALSE(drawn);
	EXPECT_EQ(drawn.error().kind, ErrorKind::usage);
}

} // namespace vp::render::test
