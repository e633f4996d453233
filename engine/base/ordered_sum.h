#pragma once

#include "base/parallel_for.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vp
{

// add(sums, i) for each of so many, on all cores. Each part has sums of its own, which are added in order: so they are
// the same for any number of threads. Sums begins as nothing and has add(const Sums&).
template <class Sums, class Add>
Sums orderedSum(std::size_t count, const Add& add)
{
	constexpr std::size_t kPart = 4096;
	std::vector<Sums> parts((count + kPart - 1) / kPart);
	tracedFor(std::size_t(0), parts.size(),
	          [&](std::size_t part)
	          {
		          Sums sums;
		          for (std::size_t i = part * kPart; i < std::min((part + 1) * kPart, count); ++i)
			          add(sums, i);
		          parts[part] = sums;
	          });
	Sums all;
	for (const Sums& part : parts)
		all.add(part);
	return all;
}

} // namespace vp
