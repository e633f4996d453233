#include "sliced_sheet.h"
#include "test_grids.h"

#include "seed/boundary_cut.h"
#include "seed/curved_seeds.h"
#include "surface/implicit_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace vp::test
{

namespace
{

using seed::OutsidePolicy;
using seed::SeedMode;
using seed::SeedOptions;

seed::SheetSeeds seedsOf(const grid::BlockSet& set, const TestPlane& plane, const SeedOptions& options)
{
	return seed::findSeeds(set, probe::makeSheet(plane.origin, plane.normal), options);
}

// The cut cells that hang together across cut faces, by search over the scan.
std::vector<std::set<CellId>> piecesOf(const grid::Block& block, const TestPlane& plane)
{
	const Side side(plane);
	const std::vector<CellId> cells = scanCutCells(block, plane);
	std::set<CellId> left(cells.begin(), cells.end());
	std::vector<std::set<CellId>> pieces;
	while (!left.empty())
	{
		std::vector<CellId> queue{*left.begin()};
		left.erase(queue[0]);
		for (std::size_t i = 0; i < queue.size(); ++i)
			for (const CellId next : cutNeighbors(block, queue[i], side))
				if (left.erase(next))
					queue.push_back(next);
		pieces.emplace_back(queue.begin(), queue.end());
	}
	return pieces;
}

// The distance from a point to what the plane cuts of the boundary: every cut boundary face, every pair of its
// crossings.
double distanceToBoundaryCut(const grid::Block& block, const TestPlane& plane)
{
	const Side side(plane);
	double nearest = std::numeric_limits<double>::infinity();
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          for (CellId c = 0; c < grid.cellCount(); ++c)
		          {
			          grid.cellFaces(c, faces);
			          for (int f = 0; f < faces.size(); ++f)
			          {
				          bool inner = false;
				          grid.forEachNeighbor(c, f, [&](CellId) { inner = true; });
				          std::vector<Vec3> crossings;
				          for (std::size_t i = 0; i < faces[f].size() && !inner; ++i)
				          {
					          const Vec3 a = grid.point(faces[f][i]);
					          const Vec3 b = grid.point(faces[f][(i + 1) % faces[f].size()]);
					          const double da = side.distance(a);
					          const double db = side.distance(b);
					          if ((da >= 0.0) != (db >= 0.0))
						          crossings.push_back(a + da / (da - db) * (b - a));
				          }
				          if (crossings.size() != 2)
					          continue;
				          for (int step = 0; step <= 1000; ++step)
					          nearest =
					              std::min(nearest, glm::length(glm::mix(crossings[0], crossings[1], step / 1000.0) -
					                                            plane.origin));
			          }
		          }
	          });
	return nearest;
}

std::vector<TestPlane> outsidePlanes(const grid::Block& block, unsigned seed)
{
	std::vector<TestPlane> planes;
	const Box around{block.bounds.lo - block.bounds.size(), block.bounds.hi + block.bounds.size()};
	const BruteForceLocator locator(block);
	for (const TestPlane& plane : randomPlanes(around, 200, seed))
		if (locator.cellsHolding(plane.origin).empty() && !scanCutCells(block, plane).empty())
			planes.push_back(plane);
	return planes;
}

} // namespace

TEST(Seeds, EveryPieceHasOne)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		for (const TestPlane& plane : randomPlanes(block.bounds, 40, 80))
			for (const SeedMode mode : {SeedMode::automatic, SeedMode::boundary})
			{
				const seed::SheetSeeds seeds = seedsOf(set, plane, {mode, OutsidePolicy::nearest});
				ASSERT_EQ(seeds.cells.size(), 1u);
				EXPECT_EQ(seeds.count, seeds.cells[0].size());
				for (const CellId seed : seeds.cells[0])
					EXPECT_TRUE(isCut(block, seed, Side(plane))) << block.name;
				for (const std::set<CellId>& piece : piecesOf(block, plane))
					EXPECT_TRUE(std::ranges::any_of(seeds.cells[0], [&](CellId seed) { return piece.contains(seed); }))
					    << block.name;
			}
	}
}

TEST(Seeds, TheHotSpotGivesItsPieceAndNoOther)
{
	for (const grid::Block& block : allGrids())
	{
		if (block.name == "three_on_a_face")
			continue; // cells overlap, so a point is in several
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		std::mt19937 random(81);
		std::uniform_int_distribution<CellId> any_cell(0, static_cast<CellId>(cellCount(block) - 1));
		for (int i = 0; i < 40; ++i)
		{
			const CellId holder = any_cell(random);
			const std::vector<Vec3> corners = cellCorners(block, holder);
			Vec3 center(0.0);
			for (const Vec3& corner : corners)
				center += corner / static_cast<double>(corners.size());
			const TestPlane plane{center, randomDirection(random)};
			const seed::SheetSeeds seeds = seedsOf(set, plane, {SeedMode::hotspot, OutsidePolicy::refuse});
			EXPECT_TRUE(seeds.hot_spot_inside) << block.name;
			EXPECT_FALSE(seeds.moved_to);
			ASSERT_EQ(seeds.count, 1u) << block.name;

			const SlicedSheet sheet = cut(cutter, plane, {SeedMode::hotspot, OutsidePolicy::refuse});
			const std::vector<CellId> found = sheet.cutCells();
			for (const std::set<CellId>& piece : piecesOf(block, plane))
				if (piece.contains(holder))
				{
					EXPECT_EQ(std::set<CellId>(found.begin(), found.end()), piece) << block.name;
				}
		}
	}
}

TEST(Seeds, OutsideTheNearestPointOfTheSheetTakesItsPlace)
{
	for (const char* name :
	     {"shell", "hexes", "tets", "mixed", "u_shape", "two_pieces", "hexagonal_prisms", "collapsed_axis"})
	{
		const grid::Block& block = gridNamed(name);
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		for (const TestPlane& plane : outsidePlanes(block, 82))
		{
			const SeedOptions options{SeedMode::hotspot, OutsidePolicy::nearest};
			const seed::SheetSeeds seeds = seedsOf(set, plane, options);
			EXPECT_FALSE(seeds.hot_spot_inside) << name;
			ASSERT_TRUE(seeds.moved_to) << name;
			EXPECT_EQ(seeds.count, 1u);
			const double distance = glm::length(*seeds.moved_to - plane.origin);
			const double expected = distanceToBoundaryCut(block, plane); // sampled, so a little too long
			EXPECT_LE(distance, expected * (1.0 + 1e-9)) << name;
			EXPECT_GE(distance, expected * (1.0 - 1e-3)) << name;
			EXPECT_NEAR(Side(plane).distance(*seeds.moved_to), 0.0, 1e-12 * block.bounds.diagonal());

			const std::vector<CellId> found = cut(cutter, plane, options).cutCells();
			const auto pieces = piecesOf(block, plane);
			EXPECT_TRUE(std::ranges::any_of(pieces, [&](const std::set<CellId>& piece)
			                                { return piece == std::set<CellId>(found.begin(), found.end()); }))
			    << name << ": exactly one piece";
		}
	}
}

TEST(Seeds, OutsideNothingIsMovedUnlessAsked)
{
	const grid::Block& block = gridNamed("shell");
	const grid::BlockSet set = setOf(block);
	for (const TestPlane& plane : outsidePlanes(block, 83))
		for (const OutsidePolicy policy : {OutsidePolicy::refuse, OutsidePolicy::report})
		{
			const seed::SheetSeeds seeds = seedsOf(set, plane, {SeedMode::hotspot, policy});
			EXPECT_FALSE(seeds.hot_spot_inside);
			EXPECT_FALSE(seeds.moved_to);
			EXPECT_EQ(seeds.count, 0u);
		}
}

TEST(Seeds, FacesInThePlaneAreThoseNoCutCellShows)
{
	const grid::Block& block = gridNamed("blob");
	const grid::BlockSet set = setOf(block);
	const auto faces = [&](const Vec3& origin, const Vec3& normal) {
		return seedsOf(set, {origin, normal}, {}).faces_in_plane[0].size();
	};
	for (int axis = 0; axis < 3; ++axis)
	{
		Vec3 normal(0.0);
		normal[axis] = 1.0;
		EXPECT_EQ(faces(block.bounds.lo, normal), 64u); // the cells behind it are wholly positive
		EXPECT_EQ(faces(block.bounds.lo, -normal), 64u);
		EXPECT_EQ(faces(block.bounds.hi, normal), 0u); // cut cells show it
		EXPECT_EQ(faces(block.bounds.center(), normal), 0u);
	}
}

TEST(Seeds, CellsAtFoldsSeed)
{
	grid::Block block = gridNamed("inverted");
	block.inverted = {3, 9, 17, 40}; // as if the grid were folded there
	std::visit([&](const auto& grid) { block.inverted_tree = grid::BlockTree(grid, block.inverted); }, block.grid);
	const grid::BlockSet set = setOf(block);
	for (const TestPlane& plane : randomPlanes(block.bounds, 20, 84))
	{
		const seed::SheetSeeds seeds = seedsOf(set, plane, {SeedMode::boundary, OutsidePolicy::nearest});
		for (const CellId cell : block.inverted)
			EXPECT_EQ(std::ranges::count(seeds.cells[0], cell) > 0, isCut(block, cell, Side(plane)));
	}
}

TEST(Seeds, SeveralBlocksEachHaveTheirOwn)
{
	grid::BlockSet set;
	set.blocks = {gridNamed("u_shape"), gridNamed("blob"), gridNamed("two_to_one")};
	for (const TestPlane& plane : randomPlanes(set.blocks[0].bounds, 20, 85))
	{
		const seed::SheetSeeds seeds = seedsOf(set, plane, {});
		ASSERT_EQ(seeds.cells.size(), 3u);
		for (std::size_t b = 0; b < 3; ++b)
			EXPECT_EQ(seeds.cells[b].empty(), scanCutCells(set.blocks[b], plane).empty());
	}
}

TEST(NearestOnSegment, IsOnTheSegment)
{
	EXPECT_EQ(seed::nearestOnSegment({0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}), Vec3(0.5, 0, 0));
	EXPECT_EQ(seed::nearestOnSegment({0, 0, 0}, {2, 0, 0}, {-3, 1, 0}), Vec3(0, 0, 0));
	EXPECT_EQ(seed::nearestOnSegment({0, 0, 0}, {2, 0, 0}, {5, 1, 0}), Vec3(2, 0, 0));
	EXPECT_EQ(seed::nearestOnSegment({1, 1, 1}, {1, 1, 1}, {5, 1, 0}), Vec3(1, 1, 1));
}

// A lattice of 3 x 4 x 5 cells whose end along x lies in the quadric x = 0: 4 x 5 faces of cells that are not cut.
TEST(Seeds, FacesInAQuadricAreTold)
{
	grid::Block block;
	block.grid = grid::UniformGrid({4, 5, 6}, Vec3(0.0), Vec3(1.0));
	grid::finishBlock(block);
	const grid::BlockSet set = setOf(block);
	const surface::ImplicitSurface form = surface::ImplicitSurface::parse("quadric:0,0,0,0,0,0,1,0,0,0").value();
	const surface::BlockSurface placed(
	    std::visit([](const auto& kind) -> surface::BlockSurface::Kind { return kind; }, form.placed(surface::Axes())));
	const seed::SheetSeeds seeds =
	    seed::findSeeds(set, {&placed, 1}, probe::makeSheet(Vec3(0.0), {1.0, 0.0, 0.0}), SeedMode::automatic);
	ASSERT_EQ(seeds.faces_in_plane.size(), 1u);
	EXPECT_EQ(seeds.faces_in_plane[0].size(), 20u);
}

} // namespace vp::test
