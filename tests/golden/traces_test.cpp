// Traces drawn as surfaces: where they are, and in what colors.

#include "synthetic_scene.h"

#include "render/passes/surface_polygons.h"
#include "vectors/trace_mesh.h"

namespace vp::render::test
{

namespace
{

class DrawnTraces : public DrawingTest
{
protected:
	// From x = -1 to x = 1, with values from 0 to 1.
	DrawnTraces()
	{
		traces_.seeds = traces_.launches = {0};
		traces_.begins = traces_.ends = {vectors::TraceEnd::steps};
		traces_.starts = {0, 2};
		for (const double x : {-1.0, 1.0})
		{
			traces_.points.emplace_back(x, 0.0, 0.0);
			traces_.times.push_back(x);
			traces_.vectors.emplace_back(1.0, 0.0, 0.0);
		}
		curves_ = vectors::curvesOf(traces_, traces_.vectors);
		values_ = vectors::alongCurves(curves_, std::vector<double>{0.0, 1.0});
	}

	Scene sceneOf(const vectors::TraceMesh& made)
	{
		Scene scene = bareScene(161, 121, 1);
		auto polygons = surfacePolygons(device(), made.mesh, {made.values, {}});
		EXPECT_TRUE(polygons);
		Surface surface;
		surface.polygons = *polygons;
		surface.lit = false;
		surface.values = ValueScale{.title = "f"};
		scene.surfaces.push_back(surface);
		return scene;
	}

	vectors::Traces traces_;
	vectors::Curves curves_;
	std::vector<double> values_;
};

// The pixel whose middle is nearest to a place.
std::array<std::uint8_t, 4> pixelAt(const Scene& scene, const Picture& picture, const Vec3& place)
{
	const glm::dvec2 at = scene.camera.project(place, pictureFrame(scene));
	return picture.pixel(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y));
}

constexpr double kTraceWidth = 0.2;
constexpr double kTolerance = 6.0; // in steps of 1 / 255: a pixel covers several colors of the map

} // namespace

TEST_F(DrawnTraces, HaveTheColorsOfTheirValues)
{
	for (const auto add : {vectors::addTubes, vectors::addLines})
	{
		vectors::TraceMesh made;
		add(curves_, values_, kTraceWidth, made);
		const Scene scene = sceneOf(made);
		const Picture picture = draw(scene);
		for (const double x : {-0.9, -0.5, 0.0, 0.4, 0.9})
			EXPECT_LE(difference(rgb(scene.look.colors.at(0.5 * x + 0.5)), pixelAt(scene, picture, {x, 0.0, 0.0})),
			          kTolerance)
			    << x;
		for (const Vec3& beside :
		     {Vec3(0.0, 0.14, 0.0), Vec3(0.0, -0.14, 0.0), Vec3(1.1, 0.0, 0.0), Vec3(-1.1, 0.0, 0.0)})
			EXPECT_EQ(difference({255.0, 255.0, 255.0}, pixelAt(scene, picture, beside)), 0.0);
	}
}

TEST_F(DrawnTraces, ArrowsAreWidestAtTheirHeadsBase)
{
	vectors::TraceMesh made;
	vectors::addArrows(curves_, values_, 0.1, made);
	const Scene scene = sceneOf(made);
	const Picture picture = draw(scene);
	const auto drawn = [&](double x, double y) {
		return difference({255.0, 255.0, 255.0}, pixelAt(scene, picture, {x, y, 0.0})) > 0.0;
	};
	EXPECT_TRUE(drawn(0.53, 0.13)); // the head is 0.5 long and 0.32 wide there
	EXPECT_FALSE(drawn(0.45, 0.13));
	EXPECT_FALSE(drawn(0.9, 0.13));
	EXPECT_TRUE(drawn(0.9, 0.0));
	EXPECT_TRUE(drawn(-0.95, 0.0));
}

TEST_F(DrawnTraces, RibbonsAreSeenFromTheirSide)
{
	vectors::TraceMesh flat;
	vectors::addRibbons(curves_, values_, kTraceWidth, {0.0, 1.0, 0.0}, {}, flat);
	vectors::TraceMesh edge;
	vectors::addRibbons(curves_, values_, kTraceWidth, {0.0, 0.0, 1.0}, {}, edge);
	const auto drawn = [&](const vectors::TraceMesh& made)
	{
		const Scene scene = sceneOf(made);
		const Picture picture = draw(scene);
		return difference({255.0, 255.0, 255.0}, pixelAt(scene, picture, {0.0, 0.07, 0.0})) > 0.0;
	};
	EXPECT_TRUE(drawn(flat));
	EXPECT_FALSE(drawn(edge));
}

} // namespace vp::render::test
