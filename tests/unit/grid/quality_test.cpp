#include "seamed_sets.h"

#include "grid/check/quality.h"

#include <gtest/gtest.h>

#include <set>

namespace vp::test
{

namespace
{

grid::Quality qualityOf(const grid::Block& block)
{
	return grid::checkQuality(setOfBlocks({block}));
}

std::size_t cellFaults(const grid::Quality& q)
{
	return q.collapsed.size() + q.inverted.size() + q.twisted.size();
}

std::size_t topologyFaults(const grid::Quality& q)
{
	return q.nonmanifold_faces.size() + q.nonmanifold_edges.size() + q.nonmanifold_points.size();
}

std::set<std::size_t> sourceCells(const grid::Block& block, const std::vector<grid::SetCell>& cells)
{
	std::set<std::size_t> sources;
	for (const grid::SetCell& cell : cells)
		sources.insert(
		    std::visit([&](const auto& grid) { return std::size_t(grid.sourceCell(cell.cell)); }, block.grid));
	return sources;
}

// The points of a box, in VTK's order of a hexahedron.
std::vector<std::int64_t> boxPoints(CellListMaker& maker, const Vec3& lo)
{
	std::vector<std::int64_t> ids;
	for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1),
	                           Vec3(1, 1, 1), Vec3(0, 1, 1)})
		ids.push_back(maker.point(lo + corner));
	return ids;
}

} // namespace

TEST(Quality, SoundGridsAreClean)
{
	for (const char* name :
	     {"blob", "graded", "shell", "hexes", "tets", "mixed", "left_handed", "u_shape", "two_pieces"})
	{
		const grid::Quality q = qualityOf(gridNamed(name));
		EXPECT_EQ(cellFaults(q), 0u) << name;
		EXPECT_EQ(topologyFaults(q), 0u) << name;
		EXPECT_TRUE(q.coincident.empty()) << name;
		EXPECT_TRUE(q.overlaps.empty()) << name;
	}
}

TEST(Quality, CollapsedCells)
{
	const grid::Quality axis = qualityOf(gridNamed("collapsed_axis"));
	EXPECT_EQ(axis.collapsed.size(), 15u);  // 5 x 3 cells at i = 0
	EXPECT_EQ(axis.coincident.size(), 20u); // six points at each of four places
	EXPECT_FALSE(axis.coincident_at_fault);
	EXPECT_TRUE(axis.twisted.empty());
	EXPECT_TRUE(axis.degenerate.empty());
	const grid::Quality hexahedra = qualityOf(gridNamed("collapsed_hexahedra"));
	EXPECT_EQ(hexahedra.degenerate.size(), 6u);
	EXPECT_TRUE(hexahedra.collapsed.empty());
}

// Simpler cells that list corners twice are sound. So are none without a volume, or whose points lie at one place by
// chance, or that list a corner at two places which no edge joins.
TEST(Quality, DegenerateCells)
{
	using Corners = std::vector<int>;
	const std::vector<Vec3> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1},
	                               {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}};
	struct Case
	{
		std::uint8_t type;
		Corners corners;
		bool is_sound;
	};
	for (const Case& c : {Case{12, {0, 1, 2, 2, 4, 4, 4, 4}, true},  // a tetrahedron
	                      Case{12, {0, 1, 2, 3, 4, 4, 4, 4}, true},  // a pyramid
	                      Case{12, {0, 1, 2, 2, 4, 5, 6, 6}, true},  // a wedge
	                      Case{12, {0, 1, 2, 3, 4, 5, 5, 4}, true},  // a wedge that lies
	                      Case{13, {0, 3, 1, 4, 4, 4}, true},        // a tetrahedron
	                      Case{13, {0, 3, 1, 4, 4, 1}, true},        // a tetrahedron
	                      Case{14, {0, 1, 2, 2, 4}, true},           // a tetrahedron
	                      Case{12, {0, 1, 2, 3, 0, 1, 2, 3}, false}, // flat
	                      Case{12, {0, 0, 1, 1, 2, 2, 2, 2}, false}, // a triangle
	                      Case{12, {0, 1, 2, 3, 4, 8, 6, 7}, false}, // two points at one place
	                      Case{12, {0, 1, 2, 3, 4, 5, 0, 7}, false}, // two ends of a diagonal
	                      Case{10, {0, 1, 3, 3}, false}})
	{
		CellListMaker maker;
		std::vector<std::int64_t> ids;
		for (const Vec3& at : places)
			maker.point(at);
		ids.assign(c.corners.begin(), c.corners.end());
		maker.cell(c.type, ids);
		const grid::Quality q = qualityOf(maker.block("one"));
		EXPECT_EQ(q.degenerate.size(), c.is_sound) << int(c.type) << " " << c.corners[2] << c.corners[4];
		EXPECT_EQ(q.collapsed.size(), !c.is_sound) << int(c.type) << " " << c.corners[2] << c.corners[4];
	}
}

TEST(Quality, InvertedCells)
{
	const grid::Block& block = gridNamed("inverted");
	std::set<std::size_t> expected;
	std::size_t cell = 0;
	for (int k = 0; k < 4; ++k)
		for (int j = 0; j < 4; ++j)
			for (int i = 0; i < 4; ++i, ++cell)
				if ((i + 2 * j + 3 * k) % 7 == 0)
					expected.insert(cell);
	const grid::Quality q = qualityOf(block);
	EXPECT_EQ(sourceCells(block, q.inverted), expected);
	EXPECT_TRUE(q.twisted.empty());
}

// Faces as VTK numbers them run counter-clockwise seen from outside where the first triangle of a wedge faces away from
// the second.
TEST(Quality, WedgesOfBothOrders)
{
	CellListMaker maker;
	std::vector<std::int64_t> low;
	std::vector<std::int64_t> high;
	for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)})
	{
		low.push_back(maker.point(p));
		high.push_back(maker.point(p + Vec3(0, 0, 1)));
	}
	maker.cell(13, {low[0], low[2], low[1], high[0], high[2], high[1]});
	EXPECT_TRUE(qualityOf(maker.block("outward")).inverted.empty());
	CellListMaker other;
	for (int k = 0; k < 2; ++k)
		for (const Vec3& p : {Vec3(0, 0, k), Vec3(1, 0, k), Vec3(0, 1, k)})
			other.point(p);
	other.cell(13, {0, 1, 2, 3, 4, 5});
	EXPECT_EQ(qualityOf(other.block("inward")).inverted.size(), 1u);
}

TEST(Quality, TwistedCells)
{
	CellListMaker maker;
	std::vector<std::int64_t> ids = boxPoints(maker, {0, 0, 0});
	maker.cell(12, ids);
	ids = boxPoints(maker, {3, 0, 0});
	std::swap(ids[4], ids[5]);
	maker.cell(12, ids);
	const grid::Block block = maker.block("twisted");
	EXPECT_EQ(sourceCells(block, qualityOf(block).twisted), std::set<std::size_t>{1});
}

TEST(Quality, FacesOfMoreThanTwoCells)
{
	const grid::Quality q = qualityOf(gridNamed("three_on_a_face"));
	ASSERT_EQ(q.nonmanifold_faces.size(), 1u);
	EXPECT_EQ(q.nonmanifold_faces[0].size(), 3u);
	EXPECT_TRUE(qualityOf(gridNamed("two_to_one")).nonmanifold_faces.empty());

	CellListMaker apart; // the same, each tetrahedron with points of its own
	for (const Vec3& tip : {Vec3(0.2, 0.2, 1), Vec3(0.4, 0.2, 1.5), Vec3(0.3, 0.3, -1)})
		apart.cell(10, {apart.point({0, 0, 0}), apart.point({1, 0, 0}), apart.point({0, 1, 0}), apart.point(tip)});
	EXPECT_EQ(qualityOf(apart.block("apart")).nonmanifold_faces.size(), 1u);
}

TEST(Quality, CellsThatMeetInAnEdgeOrAPoint)
{
	for (const auto& [lo, edges, points] : {std::tuple(Vec3(1, 1, 0), 1u, 0u), std::tuple(Vec3(1, 1, 1), 0u, 1u)})
	{
		CellListMaker maker;
		const std::vector<std::int64_t> first = boxPoints(maker, {0, 0, 0});
		maker.cell(12, first);
		std::vector<std::int64_t> second = boxPoints(maker, lo);
		if (edges)
			second[4] = first[6];
		second[0] = edges ? first[2] : first[6];
		maker.cell(12, second);
		const grid::Quality q = qualityOf(maker.block("touching"));
		EXPECT_EQ(q.nonmanifold_edges.size(), edges);
		EXPECT_EQ(q.nonmanifold_points.size(), points);
	}
}

TEST(Quality, CoincidentPointsAndOrphans)
{
	const grid::Quality unmerged = qualityOf(hexahedraBlock(warped, 0.0, 1.0, false));
	EXPECT_EQ(unmerged.coincident.size(), 8u * kSteps * kSteps * kSteps - (kSteps + 1) * (kSteps + 1) * (kSteps + 1));
	EXPECT_FALSE(unmerged.coincident_at_fault); // each cell has points of its own, as is meant
	EXPECT_EQ(topologyFaults(unmerged), 0u);
	// Two blocks in one, each merged within: somebody forgot to merge the points between them.
	CellListMaker maker;
	for (const double u : {0.0, 1.0})
	{
		std::vector<std::int64_t> ids;
		for (int i = 0; i < 3; ++i)
			for (const auto& [v, w] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
				ids.push_back(maker.point(Vec3(u + 0.5 * i, v, w)));
		for (int i = 0; i < 8; i += 4)
			maker.cell(12,
			           {ids[i], ids[i + 4], ids[i + 5], ids[i + 1], ids[i + 3], ids[i + 7], ids[i + 6], ids[i + 2]});
	}
	const grid::Quality forgotten = qualityOf(maker.block("two in one"));
	EXPECT_EQ(forgotten.coincident.size(), 4u);
	EXPECT_TRUE(forgotten.coincident_at_fault);
	EXPECT_TRUE(forgotten.degenerate.empty() && forgotten.inverted.empty());
	EXPECT_TRUE(unmerged.overlaps.empty());
	EXPECT_EQ(qualityOf(gridNamed("mixed_polyhedra")).orphans.size(), 1u);
}

TEST(Quality, OverlapsOfBlocks)
{
	for (const Place place : {straight, warped})
	{
		const auto overlaps = [&](double u0)
		{
			return grid::checkQuality(setOfBlocks({latticeBlock(place, 0.0, false), latticeBlock(place, u0, true)}))
			    .overlaps.size();
		};
		EXPECT_EQ(overlaps(1.0), 0u);
		EXPECT_GE(overlaps(0.5), std::size_t(2 * kSteps * kSteps));      // each of the cells in the common half
		EXPECT_EQ(overlaps(0.0), std::size_t(kSteps * kSteps * kSteps)); // each cell and its twin
	}
}

TEST(Quality, OverlapsWithinABlock)
{
	CellListMaker maker;
	maker.cell(12, boxPoints(maker, {0, 0, 0}));
	maker.cell(12, boxPoints(maker, {0.5, 0.5, 0}));
	maker.cell(12, boxPoints(maker, {2, 0, 0}));
	EXPECT_EQ(qualityOf(maker.block("boxes")).overlaps.size(), 1u);
	EXPECT_FALSE(qualityOf(gridNamed("three_on_a_face")).overlaps.empty());
}

// The pairs of blocks at one place grow with the square of their number, and what is looked at does not.
TEST(Quality, ManyBlocksAtOnePlace)
{
	for (const std::size_t count : {10, 50, 300})
	{
		CellListMaker maker;
		for (int x = 0; x < 3; ++x)
			maker.cell(12, boxPoints(maker, Vec3(x, 0, 0)));
		const grid::BlockSet set = setOfBlocks(std::vector<grid::Block>(count, maker.block("boxes")));
		const grid::BlockOverlaps overlaps = grid::findBlockOverlaps(set);
		EXPECT_EQ(overlaps.near, count * (count - 1) / 2);
		EXPECT_EQ(overlaps.looked_at, overlaps.pairs.size()); // each of them overlaps
		EXPECT_LE(overlaps.looked_at, 6250u);
		EXPECT_GE(overlaps.looked_at, std::min<std::size_t>(overlaps.near, 3125));
		for (const grid::BlockOverlap& pair : overlaps.pairs)
			EXPECT_EQ(pair.cells, 6u);

		const grid::Quality quality = grid::checkQuality(set);
		EXPECT_EQ(quality.overlap_samples, 3 * count);
		EXPECT_GE(quality.overlaps.size(), 3 * (count - 1));
		EXPECT_LE(quality.overlaps.size(), 3 * count * 16);
		EXPECT_EQ(quality.nonmanifold_faces.size(), 16u); // 14 outside, and two between the boxes: each counts once
	}
}

// As many in one block, each cell with points of its own.
TEST(Quality, ManyCellsAtOnePlace)
{
	CellListMaker maker;
	for (int n = 0; n < 2000; ++n)
		maker.cell(12, boxPoints(maker, Vec3(0.0)));
	const grid::Quality quality = qualityOf(maker.block("boxes"));
	EXPECT_GE(quality.overlaps.size(), 1999u);
	EXPECT_LE(quality.overlaps.size(), 2000u * 16);
}

} // namespace vp::test
