#pragma once

#include "base/result.h"

#include <stop_token>
#include <string>
#include <type_traits>
#include <utility>

namespace vp
{

/// Ends work that its caller asked to stop, from whatever depth. Whoever opens a StopScope catches it; what the work
/// has made by then is dropped.
struct Stopped
{
};

/// While it lives, work of this thread that looks by throwIfStopped() or parallelFor() ends with Stopped soon after a
/// stop request. Without one, work does not look. Scopes end in the reverse order of their beginning.
class StopScope
{
public:
	explicit StopScope(std::stop_token token) : token_(std::move(token)), previous_(std::exchange(current_, &token_)) {}
	~StopScope() { current_ = previous_; }
	StopScope(const StopScope&) = delete;
	StopScope& operator=(const StopScope&) = delete;

	/// Returns null where nobody can ask this thread's work to stop.
	static const std::stop_token* current() { return current_; }

private:
	std::stop_token token_;
	const std::stop_token* previous_;
	static inline thread_local const std::stop_token* current_ = nullptr;
};

inline void throwIfStopped(const std::stop_token* token = StopScope::current())
{
	if (token && token->stop_requested())
		throw Stopped();
}

/// Calls work(), which returns a Result, with a StopScope of this token. A stop request makes an error of it:
/// "`what` was cancelled". Where nobody can ask, there is no scope.
template <class Work>
std::invoke_result_t<Work&> endingOnRequest(const std::stop_token& stop, const char* what, Work&& work)
{
	if (!stop.stop_possible())
		return work();
	const StopScope scope(stop);
	try
	{
		return work();
	}
	catch (const Stopped&)
	{
		return Error{ErrorKind::cancelled, std::string(what) + " was cancelled"};
	}
}

} // namespace vp
