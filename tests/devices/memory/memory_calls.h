#pragma once

#include <cstddef>
#include <cstdint>

namespace vp::memory
{

/// Places of the code that may be told apart.
constexpr std::size_t kMaxPlaces = 16384;

/// Lies in a file that the failing program shares with its test.
struct MemoryCalls
{
	std::uint64_t count;
	std::uint64_t terminated;              // 1: std::terminate() was called, as where an error would leave a destructor
	std::uint64_t places;                  // how many places of the code called
	std::uint64_t first_calls[kMaxPlaces]; // the number of the first call from each, in their order
};

} // namespace vp::memory
