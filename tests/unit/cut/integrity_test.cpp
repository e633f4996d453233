#include "seamed_sets.h"

#include "cut/integrity.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

cut::SweepFindings sweep(const grid::Block& block)
{
	const grid::BlockSet set = setOfBlocks({block});
	cut::Cutter cutter(set);
	return std::move(cut::sweepForImpossibleCases(cutter).value());
}

} // namespace

TEST(Integrity, SoundCellsGiveNoImpossibleCase)
{
	for (const char* name : {"shell", "hexes", "tets", "mixed", "left_handed", "inverted", "collapsed_axis"})
	{
		const cut::SweepFindings findings = sweep(gridNamed(name));
		EXPECT_TRUE(findings.impossible.empty()) << name;
		EXPECT_GE(findings.planes, 48u) << name;
		EXPECT_GT(findings.cells, 0u) << name;
	}
}

TEST(Integrity, ABowTieIsFound)
{
	CellListMaker maker;
	for (const double x : {0.0, 2.0})
		for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
		                           Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)})
			maker.point(Vec3(x, 0, 0) + corner);
	maker.cell(12, {0, 1, 2, 3, 4, 5, 6, 7});
	maker.cell(12, {8, 9, 10, 11, 13, 12, 14, 15});
	const grid::Block block = maker.block("bow tie");
	const cut::SweepFindings findings = sweep(block);
	ASSERT_EQ(findings.impossible.size(), 1u);
	EXPECT_EQ(std::get<grid::UnstructuredGrid>(block.grid).sourceCell(findings.impossible[0].cell), 1u);
}

TEST(Integrity, BoxesAreNotSwept)
{
	EXPECT_EQ(sweep(gridNamed("blob")).planes, 0u);
	EXPECT_EQ(sweep(gridNamed("graded")).planes, 0u);
}

} // namespace vp::test
