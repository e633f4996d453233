#pragma once

#include <atomic>
#include <cstdint>

namespace vp
{

/// Counts the bytes that this process and its readers have read from files, for a trace.
inline std::atomic<std::uint64_t>& bytesRead()
{
	static std::atomic<std::uint64_t> bytes = 0;
	return bytes;
}

} // namespace vp
