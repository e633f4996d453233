#include "measure/plane_triangles.h"

#include "measure/contour_lines.h"
#include "probe/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vp::test
{

namespace
{

// Polygons in the plane z = 0.
mesh::SheetMesh meshOf(const std::vector<Vec3>& places, const std::vector<std::vector<std::uint32_t>>& polygons)
{
	mesh::SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	for (const Vec3& place : places)
	{
		mesh.positions.push_back(place);
		mesh.edges.push_back({0, 0, 1, 0.5});
	}
	for (const std::vector<std::uint32_t>& polygon : polygons)
	{
		for (const std::uint32_t v : polygon)
			mesh.polygon_vertices.push_back(v);
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({0, static_cast<CellId>(mesh.polygons())});
	}
	return mesh;
}

probe::Frame frame()
{
	return probe::makeSheet(Vec3(0.0), {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
}

} // namespace

// Two vertices of a polygon are one place of a seam with one value: a triangle with a side between
// them has no area.
TEST(PlaneTriangles, WithoutAreaAtASeamAreLeftOut)
{
	const std::vector<double> values{1.0, 2.0, 3.0, 1.0};
	for (std::uint32_t first = 0; first < 3; ++first)
	{
		std::vector<std::uint32_t> thin{0, 1, 3};
		std::rotate(thin.begin(), thin.begin() + first, thin.end());
		mesh::SheetMesh mesh = meshOf({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1e-13, 0, 0}}, {thin, {0, 1, 2}});
		EXPECT_EQ(measure::planeTriangles(mesh, frame(), values).triangles.size(), 2u);
		mesh.seam_pairs = {{0, 3}};
		const measure::PlaneTriangles triangles = measure::planeTriangles(mesh, frame(), values);
		ASSERT_EQ(triangles.triangles.size(), 1u) << first;
		EXPECT_EQ(triangles.triangles[0], (measure::PlaneTriangle{0, 1, 2}));
	}
}

TEST(PlaneTriangles, EdgesRemainThatNothingCancels)
{
	EXPECT_TRUE(measure::netEdges({}).empty());
	const std::vector<measure::NetEdge> one = measure::netEdges({{5, 3}});
	ASSERT_EQ(one.size(), 1u);
	EXPECT_EQ(std::pair(one[0].from, one[0].to), std::pair(5u, 3u));
	EXPECT_TRUE(measure::netEdges({{5, 3}, {3, 5}}).empty());
	EXPECT_EQ(measure::netEdges({{5, 3}, {1, 2}, {5, 3}}).size(), 3u);
}

// Around a peak of four triangles: a line at half its height has four places, the first of which does not come again.
TEST(PlaneTriangles, AClosedLineHasEachPlaceOnce)
{
	const mesh::SheetMesh mesh =
	    meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
	const measure::PlaneTriangles triangles =
	    measure::planeTriangles(mesh, frame(), std::vector{1.0, 0.0, 0.0, 0.0, 0.0});
	const measure::Contours contours(triangles, {0.5});
	const std::vector<measure::PlaneLine> lines = contours.lines(0);
	ASSERT_EQ(lines.size(), 1u);
	EXPECT_TRUE(lines[0].closed);
	EXPECT_EQ(lines[0].points.size(), 4u);
	const std::vector<measure::PlaneLine> area = contours.area(0, measure::Contours::kNoLevel);
	ASSERT_EQ(area.size(), 1u);
	EXPECT_EQ(area[0].points.size(), 4u);
}

} // namespace vp::test
