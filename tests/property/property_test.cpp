#include "run_pairs.h"
#include "tries.h"

#include <gtest/gtest.h>

namespace vp::test
{

TEST(Properties, HoldForRandomSetsAndPlanes)
{
	runPairs(0, tries(500));
}

} // namespace vp::test
