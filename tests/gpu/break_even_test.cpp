#include "gpu_fixture.h"
#include "test_grids.h"

#include "classify/gpu_break_even.h"

#include <algorithm>
#include <array>

namespace vp::test
{

using BreakEven = GpuTest;

TEST_F(BreakEven, IsMeasuredOnGridsOfEveryKind)
{
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		grid::BlockSet set;
		set.blocks.push_back(block);
		const auto found = classify::measureBreakEven(device(), set);
		ASSERT_TRUE(found) << found.error().message;
		constexpr std::array<std::size_t, 3> kMeasured{2048, 8192, 32768};
		EXPECT_TRUE(!found->cells || std::ranges::count(kMeasured, *found->cells) == 1);
	}
}

TEST_F(BreakEven, IsNowhereWithoutCells)
{
	const auto found = classify::measureBreakEven(device(), {});
	ASSERT_TRUE(found);
	EXPECT_FALSE(found->cells);
}

} // namespace vp::test
