#include "random_window.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

cut::CutRequest requestOf(std::vector<probe::Sheet> sheets)
{
	cut::CutRequest request;
	request.in_generations = true;
	request.probe.sheets = std::move(sheets);
	return request;
}

void expectSameCut(const find::CellCut& cut, const find::CellCut& alone)
{
	EXPECT_EQ(cut.cells, alone.cells);
	EXPECT_EQ(cut.codes, alone.codes);
	EXPECT_EQ(cut.cut_cells, alone.cut_cells);
	EXPECT_EQ(cut.generation_starts, alone.generation_starts);
}

} // namespace

// Wide generations are expanded sheet beside sheet, also where each leads across seams.
TEST(ManySheets, AreCutAsEachIsAlone)
{
	std::vector<grid::BlockSet> sets;
	sets.push_back(setOf(gridNamed("shell")));
	sets.push_back(setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)}));
	sets.push_back(setOfBlocks({hexahedraBlock(warped, 0.0, 1.0, true), hexahedraBlock(warped, 1.0, 2.0, false)}));
	for (const grid::BlockSet& set : sets)
	{
		std::mt19937 random(5);
		std::vector<probe::Sheet> sheets;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 96, 11))
		{
			sheets.push_back(probe::makeSheet(plane.origin, plane.normal));
			if (sheets.size() % 3 == 0)
				sheets.back().window = randomWindow(set.bounds(), random);
		}
		cut::Cutter cutter(set);
		const cut::Cut together = cutter.cut(requestOf(sheets)).value();
		std::size_t front = 0;
		for (std::size_t s = 0; s < sheets.size(); ++s)
		{
			const cut::Cut alone = cutter.cut(requestOf({sheets[s]})).value();
			for (std::size_t b = 0; b < set.blocks.size(); ++b)
			{
				expectSameCut(together.sheets[s].cuts[b].cells(), alone.sheets[0].cuts[b].cells());
				if (alone.sheets[0].cuts[b].cells().generations() > 0)
					front += alone.sheets[0].cuts[b].cells().generation_starts[1];
			}
		}
		EXPECT_GT(front, 1024u) << "too few cells to be shared among the cores";
	}
}

} // namespace vp::test
