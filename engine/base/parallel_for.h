#pragma once

#include "base/stop_scope.h"

#include <tbb/blocked_range.h>

#include <cstddef>

namespace vp
{

/// The body of a parallel loop, without its type: TBB's loop costs much to compile, so it is compiled once, for all
/// bodies. A part of a loop costs one call more. The body must outlive it.
class LoopBody
{
public:
	/// body(begin, end) does a part of the loop. It is called on several threads at once.
	template <class Body>
	explicit LoopBody(const Body& body)
	    : body_(&body),
	      call_([](const void* of, std::size_t begin, std::size_t end) { (*static_cast<const Body*>(of))(begin, end); })
	{
	}

	void operator()(std::size_t begin, std::size_t end) const { call_(body_, begin, end); }

private:
	const void* body_;
	void (*call_)(const void*, std::size_t, std::size_t);
};

/// Calls body(begin, end) for parts of a range that together are all of it, on all cores. The parts are grains or
/// longer. Workers appear in a trace (worker_piece.h). stop: null, or the loop ends with Stopped soon after that
/// request; then each part is a grain at most.
void runLoop(const tbb::blocked_range<std::size_t>& range, LoopBody body, const std::stop_token* stop);

/// Calls body(part) for parts of the range, which are ranges, too: see runLoop(). Index: an unsigned number, or one
/// that is never negative.
template <class Index, class Body>
void tracedFor(const tbb::blocked_range<Index>& range, const Body& body, const std::stop_token* stop = nullptr)
{
	const auto part = [&](std::size_t begin, std::size_t end)
	{ body(tbb::blocked_range<Index>(static_cast<Index>(begin), static_cast<Index>(end), range.grainsize())); };
	runLoop({static_cast<std::size_t>(range.begin()), static_cast<std::size_t>(range.end()), range.grainsize()},
	        LoopBody(part), stop);
}

/// The same for body(i), begin <= i < end.
template <class Index, class Body>
void tracedFor(Index begin, Index end, const Body& body, const std::stop_token* stop = nullptr)
{
	const auto part = [&](std::size_t first, std::size_t last)
	{
		for (std::size_t i = first; i < last; ++i)
			body(static_cast<Index>(i));
	};
	runLoop({static_cast<std::size_t>(begin), static_cast<std::size_t>(end)}, LoopBody(part), stop);
}

/// tracedFor() that ends with Stopped soon after a stop request to the StopScope of this thread. It looks before each
/// grain of the range, so body() is called for single grains where somebody may ask.
template <class Index, class Body>
void parallelFor(const tbb::blocked_range<Index>& range, const Body& body)
{
	tracedFor(range, body, StopScope::current());
}

/// The same for body(i), begin <= i < end. It looks before each.
template <class Index, class Body>
void parallelFor(Index begin, Index end, const Body& body)
{
	tracedFor(begin, end, body, StopScope::current());
}

} // namespace vp
