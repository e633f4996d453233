#pragma once

#include "base/result.h"
#include "exit_code.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace vp::app
{

// A subcommand's work, run once the command line has been read. Errors are told by main.
using Run = std::function<Result<ExitCode>()>;

// Each adds its subcommand, with its options and help, to the program.
void addInfo(CLI::App& program, Run& run);
void addSlice(CLI::App& program, Run& run);
void addRender(CLI::App& program, Run& run);
void addSweep(CLI::App& program, Run& run);
void addProfile(CLI::App& program, Run& run);
void addView(CLI::App& program, Run& run);
void addCheck(CLI::App& program, Run& run);
void addSample(CLI::App& program, Run& run);

} // namespace vp::app
