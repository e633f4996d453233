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

std::vector<CellId> cutCells(const find::CellCut& cut)
{
	std::vector<CellId> cells;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kCodeCut)
			cells.push_back(cut.cells[i]);
	return sorted(std::move(cells));
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
		auto slicer = cut::Cutter::onDevice(device(), set, field, nullptr);
		ASSERT_TRUE(slicer) << slicer.error().message;
		cut::CutRequest request;
		request.field = field;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 4, 81))
			request.probe.sheets.push_back(probe::makeSheet(plane.origin, plane.normal));
		const double size = set.bounds().diagonal();
		request.probe.sheets.back().window = probe::centredWindow(0.3 * size, 0.2 * size);
		const cut::Cut expected = std::move((*slicer)->cut(request).value());

		for (const find::Finder finder : {find::Finder::direct, find::Finder::automatic})
		{
			request.finder = finder;
			const cut::Cut found = std::move((*slicer)->cut(request).value());
			CutBothWays cut;
			for (std::size_t s = 0; s < found.sheets.size(); ++s)
			{
				const cut::SheetCut& sheet = found.sheets[s];
				EXPECT_EQ(cutCells(sheet.cuts[0]), cutCells(expected.sheets[s].cuts[0]));
				expectSameMesh(found.mesh(set, s), expected.mesh(set, s));
				at_once += sheet.cuts[0].generations() == 1;
				cut.gpu.push_back(sheet.cuts[0]);
				cut.records.push_back(sheet.records);
			}
			cut.cpu = cut.gpu;
			if (kWholeOnDevice.contains(block.name))
				expectRecords(set, request.probe.sheets, field, cut);
		}
	}
	EXPECT_GT(at_once, 40u);
}

} // namespace

} // namespace vp::test
