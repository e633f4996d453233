#include "run_pairs.h"

#include <gtest/gtest.h>

namespace vp::test
{

TEST(Properties, HoldForRandomSetsAndPlanes)
{
	runPairs(0, 500);
}

} // namespace vp::test
