#include "mesh/part_edges.h"

#include "grid/grid.h"
#include "mesh/mesh_records.h"

#include <gtest/gtest.h>

namespace vp::mesh
{

namespace
{

// Three cells of which the first two are parts of one cell of the file. Only their numbers matter here.
grid::BlockSet parts(std::vector<std::int64_t> source_cells)
{
	grid::CellList cells;
	cells.types = Array<std::uint8_t>(std::vector<std::uint8_t>(3, grid::kTetra));
	cells.connectivity =
	    grid::IdArray(Array<std::int64_t>(std::vector<std::int64_t>{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}));
	cells.source_cells = Array<std::int64_t>(std::move(source_cells));
	grid::BlockSet blocks;
	blocks.blocks.emplace_back().grid = grid::UnstructuredGrid::listed(
	    grid::Points(Array<double>(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})), cells);
	return blocks;
}

// A row of three unit squares.
SheetMesh squares()
{
	SheetMesh mesh;
	for (int i = 0; i < 4; ++i)
		for (int j = 0; j < 2; ++j)
			mesh.positions.push_back(Vec3(i, j, 0.0));
	mesh.polygon_starts = {0, 4, 8, 12};
	mesh.polygon_vertices = {0, 2, 3, 1, 2, 4, 5, 3, 4, 6, 7, 5};
	mesh.polygon_cells = {{0, 0}, {0, 1}, {0, 2}};
	return mesh;
}

} // namespace

// By hand: the first two squares are one cell, 2 x 1, and the edge between them is none of its own. Its width is 4 * 2
// / 6, that of a square 4 * 1 / 4.
TEST(PartEdges, LieWithinACellOfTheFile)
{
	const PartEdges edges = partEdges(parts({0, 0, 1}), squares());
	EXPECT_EQ(edges.is_inner, (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0}));
	ASSERT_EQ(edges.widths.size(), 3u);
	EXPECT_NEAR(edges.widths[0], 4.0 / 3.0, 1e-6);
	EXPECT_NEAR(edges.widths[1], 4.0 / 3.0, 1e-6);
	EXPECT_NEAR(edges.widths[2], 1.0, 1e-6);
}

TEST(PartEdges, WholeCellsHaveNone)
{
	EXPECT_TRUE(partEdges(parts({0, 1, 2}), squares()).is_inner.empty());
	EXPECT_TRUE(partEdges(parts({}), squares()).widths.empty());
}

TEST(PartEdges, RecordsHideThem)
{
	const SheetMesh mesh = squares();
	const probe::Sheet sheet;
	const MeshRecords records(sheet, mesh, std::vector<double>(3, 1.0), partEdges(parts({0, 0, 1}), mesh));
	ASSERT_EQ(records.count(), 3u);
	std::vector<shared::PolygonRecord> made(3);
	records.write(0, made);
	const auto hidden = [&](int r) { return made[r].vertices >> 8 & 0xFFu; };
	EXPECT_EQ(hidden(0), 2u); // the edge from its second corner
	EXPECT_EQ(hidden(1), 8u);
	EXPECT_EQ(hidden(2), 0u);
	for (const shared::PolygonRecord& record : made)
		EXPECT_EQ(record.vertices & shared::kRecordVertices, 4u);
	// 256 log2(4/3) is 106.2.
	EXPECT_EQ(made[0].vertices >> shared::kRecordWidthShift, 106u);
	EXPECT_EQ(made[2].vertices >> shared::kRecordWidthShift, 0u);
}

} // namespace vp::mesh
