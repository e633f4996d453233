// Pieces of one unstructured grid that a rank reads become one block, as in a file that holds the whole.
#include "grid/field.h"
#include "ranks/data/join_pieces.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vp::test
{

namespace
{

using Ids = std::vector<std::int64_t>;

grid::Block pieceOf(const CellListMaker& maker, grid::CellList list, double value)
{
	grid::Block piece;
	piece.name = "piece";
	const std::size_t cells = list.size();
	piece.grid = grid::UnstructuredGrid::listed(maker.points(), std::move(list));
	for (std::size_t p = 0; p < maker.points().size(); ++p)
		piece.bounds.include(maker.points()[p]);
	piece.fields = {
	    grid::makeField("s", grid::Association::point, 1, std::vector<double>(maker.points().size(), value)),
	    grid::makeField("c", grid::Association::cell, 1, std::vector<double>(cells, 10.0 * value))};
	return piece;
}

// Points along a curve in space. Where cells lie does not matter here.
CellListMaker withPoints(int count)
{
	CellListMaker maker;
	for (int i = 0; i < count; ++i)
		maker.point(Vec3(i, i * i, i * i * i));
	return maker;
}

grid::Block hexahedron()
{
	CellListMaker maker = withPoints(8);
	maker.cell(grid::kHexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
	return pieceOf(maker, maker.list(), 1.0);
}

grid::Block wedgeAndTetrahedron()
{
	CellListMaker maker = withPoints(7);
	maker.cell(grid::kWedge, {5, 4, 3, 2, 1, 0});
	maker.cell(grid::kTetra, {6, 0, 1, 2});
	return pieceOf(maker, maker.list(), 2.0);
}

grid::Block polyhedron()
{
	CellListMaker maker = withPoints(4);
	maker.polyhedron({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
	return pieceOf(maker, maker.list(), 3.0);
}

// The blocks that pieces of these blocks become.
std::vector<grid::Block> joined(std::vector<grid::Block> pieces, const std::vector<std::size_t>& of_block)
{
	read::PartBlocks read;
	for (std::size_t b = 0; b < pieces.size(); ++b)
		read.of_block.push_back({.number = b, .block = of_block[b]});
	read.set.blocks = std::move(pieces);
	read::PartList list;
	list.blocks.resize(of_block.back() + 1, {.kind = "unstructured"});
	ranks::joinPieces(read, list);
	EXPECT_EQ(read.set.blocks.size(), read.of_block.size());
	return std::move(read.set.blocks);
}

const grid::CellList& listOf(const grid::Block& block)
{
	return *std::get<grid::UnstructuredGrid>(block.grid).list();
}

Ids pointsOf(const grid::Block& block, std::size_t cell)
{
	Ids ids;
	for (auto i = listOf(block).offsets[cell]; i < listOf(block).offsets[cell + 1]; ++i)
		ids.push_back(listOf(block).connectivity[static_cast<std::size_t>(i)]);
	return ids;
}

std::vector<double> valuesOf(const grid::Field& field)
{
	std::vector<double> values(field.bytes.size() / sizeof(double));
	std::memcpy(values.data(), field.bytes.data(), field.bytes.size());
	return values;
}

} // namespace

TEST(JoinedPieces, CellsAndArraysComeOneBehindTheOther)
{
	const std::vector<grid::Block> blocks = joined({hexahedron(), wedgeAndTetrahedron(), polyhedron()}, {0, 0, 0});
	ASSERT_EQ(blocks.size(), 1u);
	const grid::Block& block = blocks[0];
	const auto& grid = std::get<grid::UnstructuredGrid>(block.grid);
	ASSERT_EQ(grid.cellCount(), 4u);
	ASSERT_EQ(grid.pointCount(), 19u);
	EXPECT_EQ(grid.point(8), Vec3(0.0));
	EXPECT_EQ(grid.point(14), Vec3(6.0, 36.0, 216.0));
	EXPECT_EQ(grid.point(18), Vec3(3.0, 9.0, 27.0));
	EXPECT_EQ(pointsOf(block, 0), (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
	EXPECT_EQ(pointsOf(block, 1), (Ids{13, 12, 11, 10, 9, 8}));
	EXPECT_EQ(pointsOf(block, 2), (Ids{14, 8, 9, 10}));
	std::vector<Ids> faces;
	listOf(block).forEachFace(3, [&](std::span<const std::int64_t> face)
	                          { faces.emplace_back(face.begin(), face.end()); });
	EXPECT_EQ(faces, (std::vector<Ids>{{15, 16, 17}, {15, 18, 16}, {16, 18, 17}, {17, 18, 15}}));
	std::vector<double> of_points(8, 1.0);
	of_points.insert(of_points.end(), 7, 2.0);
	of_points.insert(of_points.end(), 4, 3.0);
	ASSERT_EQ(block.fields.size(), 2u);
	EXPECT_EQ(valuesOf(block.fields[0]), of_points);
	EXPECT_EQ(valuesOf(block.fields[1]), (std::vector<double>{10.0, 20.0, 20.0, 30.0}));
	EXPECT_EQ(block.bounds.hi, Vec3(7.0, 49.0, 343.0));
}

// Cells that are alike need no offsets, and get none.
TEST(JoinedPieces, CellsThatAreAlikeHaveNoOffsets)
{
	const auto alike = []
	{
		CellListMaker maker = withPoints(5);
		maker.cell(grid::kTetra, {0, 1, 2, 3});
		maker.cell(grid::kTetra, {1, 2, 3, 4});
		grid::CellList list = maker.list();
		list.offsets = Array<std::int64_t>();
		return pieceOf(maker, std::move(list), 1.0);
	};
	const std::vector<grid::Block> blocks = joined({alike(), alike()}, {0, 0});
	ASSERT_EQ(blocks.size(), 1u);
	EXPECT_TRUE(listOf(blocks[0]).offsets.empty());
	EXPECT_EQ(listOf(blocks[0]).point(3, 0), 6);
	// Beside other cells, each gets its own.
	const std::vector<grid::Block> mixed = joined({alike(), hexahedron()}, {0, 0});
	EXPECT_EQ(pointsOf(mixed.at(0), 1), (Ids{1, 2, 3, 4}));
	EXPECT_EQ(pointsOf(mixed.at(0), 2), (Ids{5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST(JoinedPieces, CellsOfTheFileAreCountedOn)
{
	CellListMaker maker = withPoints(5);
	maker.cell(grid::kTetra, {0, 1, 2, 3});
	maker.cell(grid::kTetra, {1, 2, 3, 4});
	grid::CellList list = maker.list();
	list.source_cells = std::vector<std::int64_t>{0, 0};
	list.source_points = 4;
	const grid::Block split = pieceOf(maker, list, 1.0);
	const std::vector<grid::Block> blocks = joined({hexahedron(), split, split, hexahedron()}, {0, 0, 0, 0});
	ASSERT_EQ(blocks.size(), 1u);
	const grid::CellList& all = listOf(blocks[0]);
	const Ids sources(all.source_cells.data(), all.source_cells.data() + all.source_cells.size());
	EXPECT_EQ(sources, (Ids{0, 1, 1, 2, 2, 3}));
	EXPECT_EQ(all.source_points, 8u + 4 + 4 + 8);
}

TEST(JoinedPieces, OtherBlocksAndOtherArraysStayApart)
{
	EXPECT_EQ(joined({hexahedron(), hexahedron(), polyhedron()}, {0, 1, 1}).size(), 2u);
	grid::Block other = hexahedron();
	other.fields[0].name = "t";
	EXPECT_EQ(joined({hexahedron(), other, hexahedron()}, {0, 0, 0}).size(), 3u);
}

// Otherwise it would name a point of the next piece.
TEST(JoinedPieces, AWrongPointIsFound)
{
	CellListMaker maker = withPoints(4);
	maker.cell(grid::kTetra, {1, 2, 3, 4});
	grid::CellList list = maker.list();
	list.offsets = Array<std::int64_t>();
	list.has_checked_ids = false;
	const grid::Block wrong = pieceOf(maker, std::move(list), 1.0);
	EXPECT_THROW(joined({wrong, hexahedron()}, {0, 0}), grid::WrongPoint);
}

} // namespace vp::test
