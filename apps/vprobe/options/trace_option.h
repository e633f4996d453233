#pragma once

#include "write/trace_file.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace vp::app
{

void addTraceOption(CLI::App& command, std::string& path, const char* group);

// Returns no trace if the option was not given.
Result<std::optional<write::TraceFile>> openTrace(const std::string& path);

} // namespace vp::app
