#pragma once

#include "parts/source.h"

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

} // namespace vp::parts
