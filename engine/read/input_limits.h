#pragma once

#include "base/result.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace vp::read
{

// The limits for reading one input, since a damaged file can ask a reader for any amount of memory or time.
struct InputLimits
{
	std::uint64_t memory = 0; // address space of the child, and bytes that it may pass
	std::chrono::seconds time{0};
	bool follows_size = false; // the memory is less than the machine's, because the file is small
};

// Returns the limits. They follow from the size of the input and of the files beside it, which it may refer to by its
// `format`, or, if that is empty, by its name. Returns an error for a path that needs no reader: missing, a folder,
// unreadable or empty.
Result<InputLimits> inputLimits(const std::string& file, const std::string& solution, const std::string& format = {});

// The same for files that are slices of one volume.
Result<InputLimits> stackLimits(const std::vector<std::string>& files);

// The limits for a built-in data set, which the machine alone limits.
InputLimits limitsWithoutFile();

// The same for a reader that refines this number of levels. Each level makes eight cells of one.
InputLimits refinedLimits(InputLimits limits, double refine);

} // namespace vp::read
