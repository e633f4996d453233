#include "grid/unstructured.h"
#include "listed_block.h"
#include "test_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace vp::grid
{
namespace
{

// Source point ids of a cell.
std::vector<std::size_t> sourceIds(const UnstructuredGrid& grid, CellId c)
{
	std::vector<std::size_t> ids;
	for (const PointId p : grid.cellPoints(c))
		ids.push_back(grid.sourcePoint(p));
	return ids;
}

TEST(Unstructured, RenumbersOntoItself)
{
	for (const Block& block : test::allGrids())
	{
		const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
		if (!grid)
			continue;
		std::vector<std::size_t> points(grid->pointCount());
		for (PointId p = 0; p < points.size(); ++p)
			points[p] = grid->sourcePoint(p);
		std::ranges::sort(points);
		for (std::size_t p = 0; p < points.size(); ++p)
			ASSERT_EQ(points[p], p) << block.name;
		std::vector<std::size_t> cells(grid->cellCount());
		for (CellId c = 0; c < cells.size(); ++c)
			cells[c] = grid->sourceCell(c);
		std::ranges::sort(cells);
		EXPECT_EQ(std::ranges::adjacent_find(cells), cells.end()) << block.name;
	}
}

// Pairs of cells that are neighbors, by the numbers of the source.
std::set<std::pair<std::size_t, std::size_t>> pairsOfNeighbors(const UnstructuredGrid& grid)
{
	std::set<std::pair<std::size_t, std::size_t>> pairs;
	for (CellId c = 0; c < grid.cellCount(); ++c)
		for (int f = 0; f < grid.faceCount(c); ++f)
			grid.forEachNeighbor(c, f, [&](CellId n) { pairs.emplace(grid.sourceCell(c), grid.sourceCell(n)); });
	return pairs;
}

TEST(Unstructured, PartIsLinkedAsTheWholeIs)
{
	std::mt19937 random(11);
	std::size_t grids = 0;
	for (const Block& block : test::allGrids())
	{
		const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
		if (!grid || grid->hasLinks())
			continue;
		const Block list = test::listedBlock(block);
		const auto& listed = std::get<UnstructuredGrid>(list.grid);
		if (!listed.list()->face_stream.empty())
			continue;
		++grids;
		const UnstructuredGrid whole = UnstructuredGrid::build(listed.coordinates(), *listed.list());
		std::vector<CellId> cells;
		for (CellId c = 0; c < listed.cellCount(); ++c)
			if (random() % 3 != 0)
				cells.push_back(c);
		const UnstructuredGrid part = UnstructuredGrid::buildPart(listed, cells);
		ASSERT_EQ(part.cellCount(), cells.size()) << block.name;
		EXPECT_EQ(part.sourcePointCount(), whole.sourcePointCount());
		EXPECT_FALSE(part.splitsCells());
		std::set<std::size_t> points;
		for (CellId c = 0; c < part.cellCount(); ++c)
		{
			const auto source = static_cast<CellId>(part.sourceCell(c));
			EXPECT_TRUE(std::ranges::binary_search(cells, source)) << block.name;
			EXPECT_EQ(part.shape(c), listed.shape(source));
			const std::vector<std::size_t> ids = sourceIds(part, c), wanted = sourceIds(listed, source);
			EXPECT_EQ(ids, wanted) << block.name;
			points.insert(ids.begin(), ids.end());
		}
		EXPECT_EQ(points.size(), part.pointCount()) << block.name; // and no others
		for (PointId p = 0; p < part.pointCount(); ++p)
			EXPECT_EQ(part.point(p), listed.point(static_cast<PointId>(part.sourcePoint(p))));
		auto wanted = pairsOfNeighbors(whole);
		std::erase_if(wanted,
		              [&](const auto& pair)
		              {
			              return !std::ranges::binary_search(cells, static_cast<CellId>(pair.first)) ||
			                     !std::ranges::binary_search(cells, static_cast<CellId>(pair.second));
		              });
		EXPECT_EQ(pairsOfNeighbors(part), wanted) << block.name;
	}
	EXPECT_GE(grids, 3u);
}

TEST(Unstructured, LeavesFlatCellsOutAndSkipsForeignOnes)
{
	test::CellListMaker maker;
	for (int p = 0; p < 24; ++p)
		maker.point({p % 2 + 0.0, p / 2 % 3 + 0.0, p / 6 + 0.0});
	maker.cell(1, {0});
	maker.cell(5, {0, 1, 2});
	maker.cell(10, {0, 1, 2, 6});
	maker.cell(3, {0, 1});
	maker.cell(24, {0, 1, 2, 6, 7, 8, 9, 10, 11, 12}); // a quadratic tetrahedron
	maker.cell(9, {0, 1, 2, 3});
	maker.cell(10, {3, 2, 1, 6});
	const auto grid = UnstructuredGrid::build(maker.points(), maker.list());
	EXPECT_EQ(grid.leftOut(), 4u);
	ASSERT_EQ(grid.cellCount(), 2u);
	EXPECT_EQ(grid.recordWidth(), 4);
	EXPECT_EQ(std::min(grid.sourceCell(0), grid.sourceCell(1)), 2u);
	EXPECT_EQ(std::max(grid.sourceCell(0), grid.sourceCell(1)), 6u);
	EXPECT_EQ(grid.pointCount(), 24u);
	EXPECT_EQ(grid.usedPointCount(), 5u);
}

TEST(Unstructured, OnlyFlatCells)
{
	test::CellListMaker maker;
	for (int p = 0; p < 4; ++p)
		maker.point({p + 0.0, 0.0, 0.0});
	maker.cell(5, {0, 1, 2});
	Block block = maker.block("flat");
	EXPECT_EQ(std::get<UnstructuredGrid>(block.grid).cellCount(), 0u);
	EXPECT_TRUE(block.bounds.empty());
	EXPECT_NO_THROW(validate(block));
}

TEST(Unstructured, KeepsVtksOrder)
{
	test::CellListMaker maker;
	std::vector<std::int64_t> ids;
	for (int p = 0; p < 20; ++p)
		ids.push_back(maker.point({p % 2 + 0.0, p / 2 % 2 + 0.0, p / 4 + 0.0}));
	maker.cell(12, ids); // as a quadratic cell lists them: the first eight are the corners
	maker.cell(11, {0, 1, 2, 3, 4, 5, 6, 7});
	maker.cell(13, {8, 9, 10, 12, 13, 14});
	maker.cell(14, {0, 1, 3, 2, 9});
	maker.cell(10, {0, 1, 2, 19});
	const auto grid = UnstructuredGrid::build(maker.points(), maker.list());
	EXPECT_EQ(grid.recordWidth(), 8);
	const std::vector<std::vector<std::size_t>> expected = {
	    {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 3, 2, 4, 5, 7, 6}, {8, 9, 10, 12, 13, 14}, {0, 1, 3, 2, 9}, {0, 1, 2, 19}};
	const CellShape shapes[] = {CellShape::hexahedron, CellShape::hexahedron, CellShape::wedge, CellShape::pyramid,
	                            CellShape::tetrahedron};
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		EXPECT_EQ(grid.shape(c), shapes[grid.sourceCell(c)]);
		EXPECT_EQ(sourceIds(grid, c), expected[grid.sourceCell(c)]);
	}
}

TEST(Unstructured, KeepsThePrecisionOfPoints)
{
	const std::vector<float> xyz{0.1f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
	CellList cells;
	cells.types = std::vector<std::uint8_t>{10};
	cells.offsets = std::vector<std::int64_t>{0, 4};
	cells.connectivity = std::vector<std::int64_t>{0, 1, 2, 3};
	const auto single = UnstructuredGrid::build(Points(Array<float>(xyz)), cells);
	EXPECT_FALSE(single.coordinates().isDouble());
	const std::vector<double> precise(xyz.begin(), xyz.end());
	const auto twice = UnstructuredGrid::build(Points(Array<double>(precise)), cells);
	EXPECT_TRUE(twice.coordinates().isDouble());
	for (PointId p = 0; p < 4; ++p)
		EXPECT_EQ(single.point(p), twice.point(p));
}

TEST(Unstructured, PolyhedraKeepTheirFaces)
{
	const Block& block = test::gridNamed("hexagonal_prisms");
	const auto& grid = std::get<UnstructuredGrid>(block.grid);
	int prisms = 0;
	CellFaces faces;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		if (grid.shape(c) != CellShape::polyhedron)
			continue;
		++prisms;
		grid.cellFaces(c, faces);
		ASSERT_EQ(faces.size(), 8);
		EXPECT_EQ(faces[0].size(), 6u);
		int neighbors = 0;
		for (int f = 0; f < 8; ++f)
			grid.forEachNeighbor(c, f, [&](CellId) { ++neighbors; });
		// The ring around it and the other prism.
		EXPECT_EQ(neighbors, 7);
	}
	EXPECT_EQ(prisms, 2);
}

// Shuffled cells and points end where the unshuffled ones do: the curve decides.
TEST(Unstructured, OrderComesFromSpace)
{
	constexpr int n = 8;
	test::CellListMaker maker;
	std::vector<std::array<int, 3>> at;
	for (int p = 0; p < (n + 1) * (n + 1) * (n + 1); ++p)
		at.push_back({p % (n + 1), p / (n + 1) % (n + 1), p / (n + 1) / (n + 1)});
	std::mt19937 random(2);
	std::ranges::shuffle(at, random);
	std::vector<std::int64_t> id(at.size());
	for (const auto& [i, j, k] : at)
		id[(k * (n + 1) + j) * (n + 1) + i] = maker.point(Vec3(i, j, k));
	std::vector<std::array<int, 3>> cells;
	for (int c = 0; c < n * n * n; ++c)
		cells.push_back({c % n, c / n % n, c / n / n});
	std::ranges::shuffle(cells, random);
	for (const std::array<int, 3>& c : cells)
	{
		const auto p = [&](int di, int dj, int dk)
		{ return id[((c[2] + dk) * (n + 1) + c[1] + dj) * (n + 1) + c[0] + di]; };
		maker.cell(12,
		           {p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0), p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)});
	}
	const auto grid = UnstructuredGrid::build(maker.points(), maker.list());
	// Eight cells in a row form a cube of two.
	for (CellId c = 0; c < grid.cellCount(); c += 8)
	{
		Box box;
		for (CellId near = c; near < c + 8; ++near)
			box.include(cellCenter(grid, near));
		EXPECT_EQ(box.size(), Vec3(1.0));
	}
}

} // namespace
} // namespace vp::grid
