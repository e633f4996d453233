#pragma once

#include "grid/field.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace vp::measure
{

// Which arrays hold nothing but ordinary numbers: none is NaN or infinite, nor so large that a difference or a square
// would be. What is interpolated between such, and the length of a tuple, is finite without being looked at. Keeps no
// array alive. Thread safe.
class FiniteFields
{
public:
	// Returns true if all values of the array are known to be finite. lookups: the number of values that the caller
	// must check itself if the answer is no. The array is checked once the lookups of all calls together took about as
	// long. So the work follows what is shown.
	bool holds(const grid::Field& field, std::size_t lookups);

private:
	struct Known
	{
		std::weak_ptr<const void> owner; // memory of the array
		const std::byte* data;
		std::size_t lookups = 0;
		std::optional<bool> finite;
	};
	Known& entryOf(const grid::Field& field);

	std::mutex mutex_;
	std::vector<Known> known_;
};

// Looks at all values of the array, on all cores. Integers are always ordinary numbers.
bool hasOrdinaryNumbersOnly(const grid::Field& field);

} // namespace vp::measure
