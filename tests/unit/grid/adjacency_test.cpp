#include "grid/block.h"
#include "test_grids.h"
#include "tries.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace vp::grid
{
namespace
{

using Neighbors = std::vector<std::vector<std::set<CellId>>>; // per cell and face

Neighbors neighborsOf(const UnstructuredGrid& grid)
{
	Neighbors all(grid.cellCount());
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		all[c].resize(grid.faceCount(c));
		for (int f = 0; f < grid.faceCount(c); ++f)
			grid.forEachNeighbor(c, f,
			                     [&](CellId n) { EXPECT_TRUE(all[c][f].insert(n).second) << "neighbor told twice"; });
	}
	return all;
}

// Every face against every other.
Neighbors bruteForce(const UnstructuredGrid& grid)
{
	std::vector<std::vector<std::set<PointId>>> sets(grid.cellCount());
	CellFaces faces;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		grid.cellFaces(c, faces);
		for (int f = 0; f < faces.size(); ++f)
			sets[c].emplace_back(faces[f].begin(), faces[f].end());
	}
	Neighbors all(grid.cellCount());
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		all[c].resize(sets[c].size());
		for (std::size_t f = 0; f < sets[c].size(); ++f)
			for (CellId n = 0; n < grid.cellCount(); ++n)
				if (n != c && sets[c][f].size() >= 3 && std::ranges::count(sets[n], sets[c][f]) > 0)
					all[c][f].insert(n);
	}
	return all;
}

TEST(Adjacency, EqualsBruteForceOnAllGrids)
{
	for (const Block& block : test::allGrids())
	{
		const auto* grid = std::get_if<UnstructuredGrid>(&block.grid);
		if (!grid || block.name == "two_to_one")
			continue;
		EXPECT_EQ(neighborsOf(*grid), bruteForce(*grid)) << block.name;
	}
}

// Cells with ids at random from few points: faces shared by many, repeated ids, faces folded on each other.
TEST(Adjacency, EqualsBruteForceOnRandomCells)
{
	std::mt19937 random(1);
	for (int round = 0; round < 30; ++round)
	{
		test::CellListMaker maker;
		const int points = 5 + round / 3;
		for (int p = 0; p < points; ++p)
			maker.point({double(random() % 100), double(random() % 100), double(random() % 100)});
		const auto ids = [&](int count)
		{
			std::vector<std::int64_t> some;
			for (int i = 0; i < count; ++i)
				some.push_back(random() % points);
			return some;
		};
		for (int c = 0; c < 60; ++c)
		{
			constexpr int sizes[] = {4, 8, 8, 6, 5};
			const int type = random() % 6;
			if (type < 5)
				maker.cell(10 + type, ids(sizes[type]));
			else
				maker.polyhedron({ids(3), ids(4), ids(5), ids(6), ids(7)});
		}
		const Block block = maker.block("random");
		const auto& grid = std::get<UnstructuredGrid>(block.grid);
		EXPECT_EQ(neighborsOf(grid), bruteForce(grid));
		EXPECT_NO_THROW(validate(block));
	}
}

TEST(Adjacency, ThreeCellsOnAFaceKnowEachOther)
{
	const auto& grid = std::get<UnstructuredGrid>(test::gridNamed("three_on_a_face").grid);
	std::map<std::size_t, std::size_t> faces_by_neighbors;
	const Neighbors neighbors = neighborsOf(grid);
	for (const auto& cell : neighbors)
		for (const auto& across : cell)
			++faces_by_neighbors[across.size()];
	EXPECT_EQ(faces_by_neighbors, (std::map<std::size_t, std::size_t>{{0, 13}, {2, 3}}));
}

TEST(Adjacency, LinksJoinCoarseAndFine)
{
	const auto& grid = std::get<UnstructuredGrid>(test::gridNamed("two_to_one").grid);
	const Neighbors neighbors = neighborsOf(grid);
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		if (grid.sourceCell(c) == 0)
		{
			EXPECT_EQ(neighbors[c][1].size(), 4u);
			EXPECT_TRUE(neighbors[c][0].empty());
			continue;
		}
		ASSERT_EQ(neighbors[c][0].size(), 1u);
		EXPECT_EQ(grid.sourceCell(*neighbors[c][0].begin()), 0u);
		std::size_t all = 0;
		for (const auto& across : neighbors[c])
			all += across.size();
		EXPECT_EQ(all, 3u);
	}
}

TEST(Adjacency, FlatCellIsNotItsOwnNeighbor)
{
	test::CellListMaker maker;
	for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)})
		maker.point(p);
	maker.cell(12, {0, 1, 2, 3, 0, 1, 2, 3});
	const Block block = maker.block("flat");
	const Neighbors neighbors = neighborsOf(std::get<UnstructuredGrid>(block.grid));
	for (const auto& across : neighbors[0])
		EXPECT_TRUE(across.empty());
	// Its two sides; the other faces are lines.
	EXPECT_EQ(block.boundary.faces.size(), 2u);
	EXPECT_NO_THROW(validate(block));
}

TEST(Adjacency, ManyFacesAtOnePoint)
{
	// A fan of tetrahedra about one edge and a pole: all faces but the rim's share the lowest points.
	const int n = test::tries(2000);
	test::CellListMaker maker;
	maker.point({0, 0, 0});
	maker.point({0, 0, 1});
	for (int p = 0; p < n; ++p)
		maker.point({std::cos(6.2831853 * p / n), std::sin(6.2831853 * p / n), 0.5});
	for (int p = 0; p < n; ++p)
		maker.cell(10, {0, 1, 2 + p, 2 + (p + 1) % n});
	const Block block = maker.block("fan");
	EXPECT_EQ(neighborsOf(std::get<UnstructuredGrid>(block.grid)), bruteForce(std::get<UnstructuredGrid>(block.grid)));
}

TEST(Adjacency, CellsGivenThousandsOfTimes)
{
	test::CellListMaker maker;
	for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
		maker.point(p);
	for (int c = 0; c < 20000; ++c)
		maker.cell(10, {0, 1, 2, 3});
	const Block block = maker.block("same");
	EXPECT_NO_THROW(validate(block));
	// Still connected through any one face.
	const auto& grid = std::get<UnstructuredGrid>(block.grid);
	std::vector<CellId> queue{0};
	std::set<CellId> seen{0};
	for (std::size_t at = 0; at < queue.size(); ++at)
		grid.forEachNeighbor(queue[at], 2,
		                     [&](CellId n)
		                     {
			                     if (seen.insert(n).second)
				                     queue.push_back(n);
		                     });
	EXPECT_EQ(seen.size(), grid.cellCount());
}

TEST(Adjacency, SameForAnyNumberOfThreads)
{
	std::mt19937 random(5);
	test::CellListMaker maker;
	for (int p = 0; p < 400; ++p)
		maker.point({double(random() % 1000), double(random() % 1000), double(random() % 1000)});
	const auto id = [&](int most) { return static_cast<std::int64_t>(random() % most); };
	for (int c = 0; c < 60000; ++c)
		maker.cell(10, {id(400), id(400), id(12), id(12)});
	const auto build = [&](std::size_t threads)
	{
		const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
		return UnstructuredGrid::build(maker.points(), maker.list());
	};
	const UnstructuredGrid one = build(1);
	for (int round = 0; round < 3; ++round)
	{
		const UnstructuredGrid two = build(2);
		ASSERT_EQ(one.records(), two.records());
		for (CellId c = 0; c < one.cellCount(); ++c)
		{
			ASSERT_EQ(one.sourceCell(c), two.sourceCell(c));
			for (int f = 0; f < one.faceCount(c); ++f)
			{
				// In the same order, too.
				std::vector<CellId> a;
				std::vector<CellId> b;
				one.forEachNeighbor(c, f, [&](CellId n) { a.push_back(n); });
				two.forEachNeighbor(c, f, [&](CellId n) { b.push_back(n); });
				ASSERT_EQ(a, b);
			}
		}
		for (PointId p = 0; p < one.pointCount(); ++p)
			ASSERT_EQ(one.sourcePoint(p), two.sourcePoint(p));
	}
}

} // namespace
} // namespace vp::grid
