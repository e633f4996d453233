#pragma once

#include "base/result.h"
#include "parts/source.h"

#include <vprobe/result.h>

#include <exception>
#include <new>
#include <type_traits>
#include <utility>

namespace vprobe
{

// The border between the engine and its callers: errors get the public type, and no exception crosses.

inline Error publicError(const vp::Error& error)
{
	static_assert(static_cast<int>(ErrorKind::internal) == static_cast<int>(vp::ErrorKind::internal));
	return {static_cast<ErrorKind>(error.kind), error.message};
}

inline Status publicStatus(const vp::Status& status)
{
	return status ? Status(Nothing{}) : publicError(status.error());
}

// Runs `work`, which returns a public Result.
template <class Work>
std::invoke_result_t<Work> guarded(Work&& work)
{
	try
	{
		return work();
	}
	catch (const std::bad_alloc&)
	{
		return Error{ErrorKind::out_of_memory, "out of memory; use a smaller input or a machine with more memory"};
	}
	catch (const vp::parts::Unreadable& error)
	{
		return Error{ErrorKind::input, error.what()};
	}
	catch (const std::exception& error)
	{
		return Error{ErrorKind::internal, error.what()};
	}
}

} // namespace vprobe
