#include "run_pairs.h"

#include <gtest/gtest.h>

namespace vp::test
{

TEST(Properties, HoldForMany)
{
	runPairs(1000, 10000);
}

} // namespace vp::test
