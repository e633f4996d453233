#include "exact_order.h"

namespace vp::render::test
{

using ExactOrderLong = ExactOrder;

TEST_F(ExactOrderLong, OfAHundredRandomProbes)
{
	compareProbes(1001, 100);
}

} // namespace vp::render::test
