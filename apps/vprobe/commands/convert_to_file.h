#pragma once

#include "base/result.h"
#include "read/read.h"

#include <CLI/CLI.hpp>

#include <string>

namespace vp::app
{

// Adds --part: the most cells of a part of an unstructured grid.
constexpr int kUsualPart = 1024;
void addPartSize(CLI::App& command, int& part);

// Has the reading process write one file, beside the output, which takes its place when it is whole.
Status convertToFile(const std::string& input, const read::ReadOptions& reading, const std::string& output);

} // namespace vp::app
