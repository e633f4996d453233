#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "test_grids.h"

#include "cut/cutter.h"

namespace vp::test
{

using Regather = GpuTest;

// The values of a time after another: what was cut is drawn with the new ones, and nothing is cut again.
TEST_F(Regather, GivesTheRecordsOfANewCut)
{
	for (const char* name : {"shell", "tets", "mixed"})
	{
		grid::BlockSet set;
		set.blocks.push_back(gridNamed(name));
		const grid::FieldChoice field{"linear", grid::Association::point, 0};
		auto cutter = cut::Cutter::onDevice(device(), set, field, nullptr);
		ASSERT_TRUE(cutter) << cutter.error().message;
		cut::CutRequest request;
		request.in_generations = true;
		request.field = field;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 3, 80))
			request.probe.sheets.push_back(probe::makeSheet(plane.origin, plane.normal));
		const cut::Cut before = std::move((*cutter)->cut(request).value());

		for (grid::Field& values : set.blocks[0].fields)
		{
			if (values.name != "linear")
				continue;
			std::vector<double> changed(values.tuples());
			for (std::size_t i = 0; i < changed.size(); ++i)
				changed[i] = 3.0 - 2.0 * values.value(i, 0);
			values = grid::makeField("linear", grid::Association::point, 1, std::move(changed));
		}
		(*cutter)->forgetValues();
		auto after = (*cutter)->regather(before, nullptr);
		ASSERT_TRUE(after) << after.error().message;

		CutBothWays cut;
		for (const cut::SheetCut& sheet : after->sheets)
		{
			for (const find::BlockCut& in_block : sheet.cuts)
				cut.gpu.push_back(in_block.cells());
			cut.records.push_back(sheet.records);
		}
		cut.cpu = cut.gpu;
		cut.singles = !device().hasExactDoubles();
		expectRecords(set, request.probe.sheets, field, cut);
		for (std::size_t s = 0; s < before.sheets.size(); ++s)
		{
			EXPECT_EQ(after->sheets[s].cuts[0].cells().cells, before.sheets[s].cuts[0].cells().cells);
			EXPECT_NE(after->sheets[s].records, before.sheets[s].records);
		}
	}
}

} // namespace vp::test
