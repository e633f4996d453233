#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "same_mesh.h"
#include "test_grids.h"

#include "cut/cutter.h"

#include <set>
#include <string>

namespace vp::test
{

namespace
{

using WideFront = GpuTest;

// Without cells that the device leaves to the host.
const std::set<std::string> kWholeOnDevice = {"shell", "tets", "mixed", "blob", "graded"};

std::vector<CellId> cutCells(const grid::Block& block, const find::BlockCut& cut)
{
	std::vector<CellId> cells;
	find::forEachCutCell(block, cut, [&](CellId cell) { cells.push_back(cell); });
	return sorted(std::move(cells));
}

// The front that the device classified, with the codes of a device that leaves nothing to the host.
find::CellCut frontOf(const grid::Block& block, const probe::Sheet& sheet, const find::BlockCut& cut)
{
	if (!cut.hasSpans())
		return cut.cells();
	find::CellCut front = find::asOneFront(block, cut);
	std::visit(
	    [&](const auto& grid)
	    {
		    for (std::size_t i = 0; i < front.cells.size(); ++i)
			    front.codes[i] = find::classifyByTable(grid, sheet.plane(), front.cells[i], grid.shape(front.cells[i]));
	    },
	    block.grid);
	return front;
}

// Cells that were found without a traversal go to the device at once: the same as generation by generation.
TEST_F(WideFront, ShowsWhatTheTraversalShows)
{
	std::size_t at_once = 0;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		grid::BlockSet set;
		set.blocks.push_back(block);
		const grid::FieldChoice field{"linear", grid::Association::point, 0};
		auto cutter = cut::Cutter::onDevice(device(), set, field, nullptr);
		ASSERT_TRUE(cutter) << cutter.error().message;
		cut::CutRequest request;
		request.in_generations = true;
		request.field = field;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 4, 81))
			request.probe.sheets.push_back(probe::makeSheet(plane.origin, plane.normal));
		const double size = set.bounds().diagonal();
		request.probe.sheets.back().window = probe::centeredWindow(0.3 * size, 0.2 * size);
		const cut::Cut expected = std::move((*cutter)->cut(request).value());

		request.in_generations = false;
		for (const bool device_first : {true, false})
		{
			request.device_first = device_first;
			const cut::Cut found = std::move((*cutter)->cut(request).value());
			CutBothWays cut;
			for (std::size_t s = 0; s < found.sheets.size(); ++s)
			{
				const cut::SheetCut& sheet = found.sheets[s];
				EXPECT_EQ(cutCells(set.blocks[0], sheet.cuts[0]), cutCells(set.blocks[0], expected.sheets[s].cuts[0]));
				expectSameMesh(found.mesh(set, s), expected.mesh(set, s));
				at_once += sheet.cuts[0].steps() == 1;
				cut.gpu.push_back(frontOf(set.blocks[0], sheet.sheet, sheet.cuts[0]));
				cut.records.push_back(sheet.records);
			}
			cut.cpu = cut.gpu;
			cut.singles = !device().hasExactDoubles();
			if (kWholeOnDevice.contains(block.name))
				expectRecords(set, request.probe.sheets, field, cut);
		}
	}
	EXPECT_GT(at_once, 40u);
}

} // namespace

} // namespace vp::test
