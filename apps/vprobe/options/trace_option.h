#pragma once

#include "session/session.h"
#include "write/trace_file.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

void addTraceOption(CLI::App& command, std::string& path, const char* group);

// Returns no trace if the option was not given.
Result<std::optional<write::TraceFile>> openTrace(const std::string& path);

// Hands over what the timeline of a session holds.
void addToTrace(const session::Session& session, write::TraceFile& trace);

// Says of what a trace is. device, driver: "none" without a device.
void describeTrace(write::TraceFile& trace, const std::vector<std::string>& inputs, const std::string& device,
                   const std::string& driver);

// Says of what the trace is, the program, its command line, and the session's inputs and device, and puts the file in
// its place.
Status commitTrace(const session::Session& session, write::TraceFile& trace);

} // namespace vp::app
