#include "mesh/clip.h"

#include "mesh/bridges.h"

#include "measure/components.h"
#include "measure/stats.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

mesh::SheetMesh polygonsAt(const std::vector<Vec3>& places, const std::vector<std::vector<std::uint32_t>>& polygons)
{
	mesh::SheetMesh mesh;
	mesh.positions.assign(places.begin(), places.end());
	for (std::uint32_t v = 0; v < places.size(); ++v)
		mesh.edges.push_back({0, 2 * v, 2 * v + 1, 0.5});
	mesh.polygon_starts.push_back(0);
	for (const std::vector<std::uint32_t>& polygon : polygons)
	{
		mesh.polygon_vertices.insert(mesh.polygon_vertices.end(), polygon.begin(), polygon.end());
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({0, static_cast<CellId>(mesh.polygon_cells.size())});
	}
	return mesh;
}

// Arms from x = 0 to 1 and 2 to 3, up to y = 3, on a foot up to y = 1.
const std::vector<Vec3> kU{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
const std::vector<std::uint32_t> kAroundU{0, 1, 2, 3, 4, 5, 6, 7};

mesh::SheetMesh uAndSquare()
{
	std::vector<Vec3> places = kU;
	places.insert(places.end(), {{5, 0, 0}, {6, 0, 0}, {6, 3, 0}, {5, 3, 0}});
	return polygonsAt(places, {kAroundU, {8, 9, 10, 11}});
}

// A square from 0 to 3 with a hole from 1 to 2.
mesh::SheetMesh ring()
{
	return polygonsAt({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
	                  {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
}

double partsArea(const mesh::SheetMesh& mesh)
{
	double area = 0.0;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const double of_polygon = 0.5 * mesh::doubleArea(mesh, mesh.polygon(p)).z;
		EXPECT_GT(of_polygon, 0.0);
		area += of_polygon;
	}
	return area;
}

mesh::SheetMesh keptWithin(mesh::SheetMesh mesh, const std::vector<mesh::ClipSide>& sides)
{
	mesh::clipToSides(Vec3(0.0), sides, mesh::Corners::keep, mesh);
	return mesh;
}

} // namespace

TEST(RimChains, AConcavePolygonLeavesSeveral)
{
	const mesh::SheetMesh arms = keptWithin(uAndSquare(), {{Vec3(0, 1, 0), 2.0}});
	ASSERT_EQ(arms.polygons(), 3u);
	EXPECT_DOUBLE_EQ(partsArea(arms), 3.0);
	EXPECT_EQ(measure::countComponents(arms), 3u);
	std::vector<CellId> cells;
	for (const mesh::BlockCell& cell : arms.polygon_cells)
		cells.push_back(cell.cell);
	std::ranges::sort(cells);
	EXPECT_EQ(cells, (std::vector<CellId>{0, 0, 1}));

	// The arms of the second cut are clipped at each further side.
	const mesh::SheetMesh corner =
	    keptWithin(uAndSquare(), {{Vec3(0, 1, 0), 2.0}, {Vec3(-1, 0, 0), -2.5}, {Vec3(1, 0, 0), 0.75}});
	EXPECT_EQ(corner.polygons(), 2u);
	EXPECT_DOUBLE_EQ(partsArea(corner), 0.75);

	// A side along the floor between the arms leaves them apart; one below it leaves one piece.
	EXPECT_EQ(keptWithin(uAndSquare(), {{Vec3(0, 1, 0), 1.0}}).polygons(), 2u);
	EXPECT_EQ(keptWithin(uAndSquare(), {{Vec3(0, 1, 0), 0.5}}).polygons(), 2u);
	EXPECT_DOUBLE_EQ(partsArea(keptWithin(uAndSquare(), {{Vec3(0, 1, 0), 0.5}})), 5.5 + 2.5);
}

TEST(RimChains, BoundaryFacesStayTheLastOnes)
{
	mesh::SheetMesh mesh = polygonsAt(kU, {kAroundU, kAroundU});
	mesh.boundary_polygons = 1;
	const mesh::SheetMesh arms = keptWithin(mesh, {{Vec3(0, 1, 0), 2.0}});
	ASSERT_EQ(arms.polygons(), 4u);
	EXPECT_EQ(arms.boundary_polygons, 2u);
	for (std::size_t p = 0; p < 4; ++p)
		EXPECT_EQ(arms.polygon_cells[p].cell, p / 2);
}

TEST(RimChains, AHoleStaysAHole)
{
	// The bridge is cut, the hole is not.
	const mesh::SheetMesh beside = keptWithin(ring(), {{Vec3(1, 0, 0), 0.5}, {Vec3(0, 1, 0), 0.25}});
	ASSERT_EQ(beside.polygons(), 1u);
	EXPECT_DOUBLE_EQ(partsArea(beside), 2.5 * 2.75 - 1.0);
	// Through the hole: one piece around three sides of it.
	const mesh::SheetMesh half = keptWithin(ring(), {{Vec3(1, 0, 0), 1.5}});
	EXPECT_EQ(measure::countComponents(half), 1u);
	EXPECT_DOUBLE_EQ(partsArea(half), 4.0);
	// A strip through the hole: two pieces.
	for (const bool upright : {false, true})
	{
		const Vec3 across = upright ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
		const mesh::SheetMesh strip = keptWithin(ring(), {{across, 1.25}, {-across, -1.75}});
		EXPECT_EQ(strip.polygons(), 2u);
		EXPECT_DOUBLE_EQ(partsArea(strip), 1.0);
	}
	// Within the hole there is nothing.
	const std::vector<mesh::ClipSide> inside{
	    {Vec3(1, 0, 0), 1.25}, {Vec3(-1, 0, 0), -1.75}, {Vec3(0, 1, 0), 1.25}, {Vec3(0, -1, 0), -1.75}};
	EXPECT_EQ(keptWithin(ring(), inside).polygons(), 0u);
}

// The rim runs along a diagonal of 4 x 4 squares, through corners of theirs: those are no cuts.
TEST(RimChains, ACornerOnTheRimIsOneCorner)
{
	grid::Block block;
	block.grid = grid::UniformGrid({5, 5, 2}, Vec3(-2.0, -2.0, -0.5), Vec3(1.0));
	grid::finishBlock(block);
	const grid::BlockSet blocks = setOf(block);
	cut::Cutter cutter(blocks);
	for (const probe::Window& window : {probe::Window{-9.0, 0.0, -9.0, 9.0}, probe::Window{0.0, 9.0, -9.0, 9.0}})
	{
		cut::CutRequest request;
		request.probe.sheets = {probe::makeSheet(Vec3(0.0), {0.0, 0.0, 1.0}, {1.0, 1.0, 0.0})};
		request.probe.sheets[0].window = window;
		const cut::Cut slice = std::move(cutter.cut(std::move(request)).value());
		const mesh::SheetMesh mesh = slice.mesh(blocks, 0);
		EXPECT_EQ(mesh.positions.size(), 15u);
		EXPECT_EQ(mesh.polygons(), 6u + 4u);
		EXPECT_EQ(mesh.polygon_vertices.size(), 6u * 4u + 4u * 3u);
	}
}

} // namespace vp::test
