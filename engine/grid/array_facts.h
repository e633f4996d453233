#pragma once

#include "grid/labels.h"

#include <cstdint>
#include <vector>

namespace vp::grid
{

// Facts that a file tells about all values of an array, of which some may not have been read yet.
struct ArrayFacts
{
	std::uint64_t tuples = 0;
	std::vector<ValueSpan> spans{};       // valueSpan() of each component, and last of kMagnitude
	std::vector<double> least_positive{}; // leastPositive() of the same, or empty
	// distinctValues() and changesOf(), if the array has one component of integers. Else empty.
	Distinct values{};
	Changes changes{};
};

} // namespace vp::grid
