#pragma once

#include "base/parallel_for.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vp
{

/// Returns join(join(nothing, take(part, nothing)), ...) over parts of 0 to count that together are all of it, on all
/// cores; `nothing` where count is 0. Parts have `grain` numbers or more. They are the same for any number of threads,
/// and joined in their order, so the result is, too.
template <class Value, class Take, class Join>
Value parallelReduce(std::size_t count, std::size_t grain, const Value& nothing, const Take& take, const Join& join)
{
	constexpr std::size_t kMostParts = 64;
	const std::size_t size = std::max(grain, (count + kMostParts - 1) / kMostParts);
	struct Part // a vector of bool would share bytes
	{
		Value value;
	};
	std::vector<Part> parts((count + size - 1) / size, Part{nothing});
	tracedFor(std::size_t(0), parts.size(),
	          [&](std::size_t part)
	          {
		          const tbb::blocked_range<std::size_t> range(part * size, std::min((part + 1) * size, count));
		          parts[part].value = take(range, std::move(parts[part].value));
	          });
	Value all = nothing;
	for (const Part& part : parts)
		all = join(std::move(all), part.value);
	return all;
}

} // namespace vp
