#pragma once

#include "base/parallel_for.h"

#include <algorithm>
#include <cstddef>

namespace vp::refine
{

constexpr std::size_t kPartsAtOnce = 2048; // whatever the number of threads

// Returns how many ranges so many parts make.
constexpr std::size_t rangesOf(std::size_t parts)
{
	return (parts + kPartsAtOnce - 1) / kPartsAtOnce;
}

// Calls body(range, begin, end) for all ranges, in parallel.
template <class Body>
void forEachRange(std::size_t count, Body&& body)
{
	tracedFor(std::size_t(0), rangesOf(count),
	          [&](std::size_t r) { body(r, r * kPartsAtOnce, std::min((r + 1) * kPartsAtOnce, count)); });
}

} // namespace vp::refine
