#pragma once

#include "base/stop_scope.h"
#include "base/worker_piece.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace vp
{

/// tbb::parallel_for() whose workers appear in a trace (worker_piece.h).
template <class Index, class Body>
void tracedFor(const tbb::blocked_range<Index>& range, const Body& body)
{
	tbb::parallel_for(range, traced(body));
}

/// The same for body(i), begin <= i < end.
template <class Index, class Body>
void tracedFor(Index begin, Index end, const Body& body)
{
	const auto each = [&](const tbb::blocked_range<Index>& part)
	{
		for (Index i = part.begin(); i < part.end(); ++i)
			body(i);
	};
	tracedFor(tbb::blocked_range<Index>(begin, end), each);
}

/// tracedFor() that ends with Stopped soon after a stop request to the StopScope of this thread. It looks before each
/// grain of the range, so body() is called for single grains where somebody may ask.
template <class Index, class Body>
void parallelFor(const tbb::blocked_range<Index>& range, const Body& body)
{
	const std::stop_token* stop = StopScope::current();
	if (!stop)
		return tracedFor(range, body);
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
	tracedFor(range, byGrain);
}

/// The same for body(i), begin <= i < end. It looks before each.
template <class Index, class Body>
void parallelFor(Index begin, Index end, const Body& body)
{
	const std::stop_token* stop = StopScope::current();
	if (!stop)
		return tracedFor(begin, end, body);
	tracedFor(begin, end,
	          [&](Index i)
	          {
		          throwIfStopped(stop);
		          body(i);
	          });
}

} // namespace vp
