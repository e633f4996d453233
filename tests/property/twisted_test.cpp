#include "pair_checks.h"
#include "tries.h"
#include "twisted_sets.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

void checkMask(LatticeKind kind, std::uint32_t mask, unsigned seed)
{
	const TwistedSet twisted = twistedSet(kind, mask, seed);
	const grid::BlockSet set = build(twisted.raw);
	cut::Cutter cutter(set);
	const TestPlane plane{twisted.plane.origin, probe::makeSheet(twisted.plane.origin, twisted.plane.normal).normal};
	const Pair pair{twisted.raw, set, twisted.plane, plane, cut(cutter, twisted.plane), isGeneric(set, plane)};
	EXPECT_TRUE(pair.generic);
	checkCells(pair);
	checkVertices(pair);
	checkAreas(pair);
	checkWatertight(pair);
	checkInvariance(pair, seed);
	bool found = false;
	for (const CellId cell : pair.sheet.cutCells())
		found |= visitGrid(set.blocks[0], [&](const auto& grid) { return grid.sourceCell(cell) == twisted.cell; });
	EXPECT_TRUE(found) << "the twisted cell is not cut";
}

void checkMasks(LatticeKind kind, std::uint32_t step, unsigned seeds)
{
	const std::uint32_t all = (1u << twistedPoints(kind)) - 1u;
	for (std::uint32_t mask = 1; mask < all; mask += step * tryEvery())
		for (unsigned seed = 0; seed < seeds; ++seed)
		{
			checkMask(kind, mask, 100 * mask + seed);
			if (testing::Test::HasFailure())
			{
				ADD_FAILURE() << "mask " << mask << ", seed " << 100 * mask + seed;
				return;
			}
		}
}

} // namespace

TEST(Twisted, EveryMaskOfAHexahedron)
{
	checkMasks(LatticeKind::curvilinear, 1, 2);
	checkMasks(LatticeKind::hexahedra, 1, 2);
}

TEST(Twisted, EveryMaskOfTheOtherShapes)
{
	checkMasks(LatticeKind::tetrahedra, 1, 4);
	checkMasks(LatticeKind::pyramids, 1, 4);
	checkMasks(LatticeKind::wedges, 1, 4);
}

TEST(Twisted, PolyhedraWithWarpedFaces)
{
	checkMasks(LatticeKind::polyhedra, 1, 1);
	checkMasks(LatticeKind::hexagonal, 23, 1); // a cell of twelve points
	checkMasks(LatticeKind::doubles, 29, 1);
}

} // namespace vp::test
