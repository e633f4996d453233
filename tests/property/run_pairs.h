#pragma once

namespace vp::test
{

// Pairs of a random set and a random plane, numbered from `first`, held against every check. The first that fails is
// described, with the number by which VPROBE_PAIR=NUMBER runs it alone.
void runPairs(unsigned first, unsigned count);

} // namespace vp::test
