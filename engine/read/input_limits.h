#pragma once

#include "base/result.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace vp::read
{

// What reading one input may take. A damaged file can ask a reader for any amount of memory or time.
struct InputLimits
{
	std::uint64_t memory = 0; // address space of the child, and bytes it may hand over
	std::chrono::seconds time{0};
};

// Refuses a path that no reader need be started for: missing, a folder, unreadable, empty. Otherwise the limits, which
// follow from the bytes of the input and of what lies beside it for it to refer to.
Result<InputLimits> inputLimits(const std::string& file, const std::string& solution);

// The same where the reader refines so many levels: each makes eight cells of one.
InputLimits refinedLimits(InputLimits limits, int refine);

} // namespace vp::read
