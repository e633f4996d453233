#pragma once

#include "base/stop_scope.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace vp
{

/// tbb::parallel_for() that ends with Stopped soon after a stop request to the StopScope of this thread. It looks
/// before each grain of the range, so body() is called for single grains where somebody may ask.
template <class Index, class Body>
void parallelFor(const tbb::blocked_range<Index>& range, const Body& body)
{
	const std::stop_token* stop = StopScope::current();
	if (!stop)
		return tbb::parallel_for(range, body);
	const auto byGrain = [&](const tbb::blocked_range<Index>& part)
	{
		const auto grain = static_cast<Index>(part.grainsize());
		for (Index begin = part.begin(); begin < part.end();)
		{
			throwIfStopped(stop);
			const Index end = part.end() - begin > grain ? begin + grain : part.end();
			body(tbb::blocked_range<Index>(begin, end, part.grainsize()));
			begin = end;
		}
	};
	tbb::parallel_for(range, byGrain);
}

/// The same for body(i), begin <= i < end. It looks before each.
template <class Index, class Body>
void parallelFor(Index begin, Index end, const Body& body)
{
	const std::stop_token* stop = StopScope::current();
	if (!stop)
		return tbb::parallel_for(begin, end, body);
	tbb::parallel_for(begin, end,
	                  [&](Index i)
	                  {
		                  throwIfStopped(stop);
		                  body(i);
	                  });
}

} // namespace vp
