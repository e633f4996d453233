#pragma once

#include "base/result.h"
#include "read/input_limits.h"
#include "read/mapping.h"
#include "read/read.h"

#include <string>

namespace vp::read
{

// The data from the child. Nothing is checked yet.
struct HandedOver
{
	std::string manifest;
	SharedBytes arrays;
	SharedBytes cells;
};

// Runs vprobe-read on one file, within its limits. Every failure of the child is an error that names the file.
Result<HandedOver> runReader(const std::string& file, const ReadOptions& options, const InputLimits& limits);

// Returns the error of a reading that was asked to stop.
Error stopped(const std::string& input);

// Returns the path of the program to run: beside this one, or in ../libexec/vprobe/ from there.
Result<std::string> readerProgram();

// For tests: sets the program to run instead. An empty path restores the search.
void setReaderProgram(std::string path);

} // namespace vp::read
