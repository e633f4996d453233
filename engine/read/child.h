#pragma once

#include "base/result.h"
#include "read/input_limits.h"
#include "read/mapping.h"
#include "read/read.h"

#include <string>

namespace vp::read
{

// What the child handed over. No part of it is checked yet.
struct HandedOver
{
	std::string manifest;
	SharedBytes arrays;
	SharedBytes cells;
};

// Runs vprobe-read on one file, within its limits. Whatever goes wrong with the child is an error that names the file.
Result<HandedOver> runReader(const std::string& file, const ReadOptions& options, const InputLimits& limits);

// What reading ends with when it was asked to stop.
Error stopped(const std::string& input);

// The program that is run: beside this one, or ../libexec/vprobe/ from there.
Result<std::string> readerProgram();

// For tests: the program to run instead; empty restores the search.
void setReaderProgram(std::string path);

} // namespace vp::read
