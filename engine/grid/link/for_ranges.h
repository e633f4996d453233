#pragma once

#include "base/parallel_for.h"

#include <tbb/blocked_range.h>

#include <cstddef>

namespace vp::grid
{

// Calls body(i) for i < count, on all cores.
template <class Body>
void forRanges(std::size_t count, Body&& body)
{
	parallelFor(tbb::blocked_range<std::size_t>(0, count, 4096),
	            [&](const tbb::blocked_range<std::size_t>& range)
	            {
		            for (std::size_t i = range.begin(); i < range.end(); ++i)
			            body(i);
	            });
}

} // namespace vp::grid
