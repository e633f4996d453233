#pragma once

#include "base/parallel_for.h"
#include "parts/source.h"

#include <cstddef>
#include <stop_token>
#include <utility>

namespace vp::parts
{

/// Reading was stopped, and nothing is wrong. What was read until then is kept.
class Stopped : public Unreadable
{
public:
	Stopped() : Unreadable("reading was stopped") {}
};

/// As long as an object of this class exists, PartStore::fetch() on its thread throws Stopped soon after a stop
/// request.
class Stoppable
{
public:
	explicit Stoppable(std::stop_token stop) : before_(std::exchange(current(), std::move(stop))) {}
	~Stoppable() { current() = std::move(before_); }
	Stoppable(const Stoppable&) = delete;
	Stoppable& operator=(const Stoppable&) = delete;

	/// Returns the token of the innermost object of this thread; without one, a token that nobody can use.
	static std::stop_token& current();

private:
	std::stop_token before_;
};

/// Calls act(ITEM) for each, on all cores. Throws Stopped soon after a stop request.
template <class Items, class Act>
void forEachStoppable(const Items& items, const Act& act)
{
	const std::stop_token stop = Stoppable::current();
	tracedFor(std::size_t(0), items.size(),
	          [&](std::size_t i)
	          {
		          if (stop.stop_requested())
			          throw Stopped();
		          act(items[i]);
	          });
}

} // namespace vp::parts
