#pragma once

#include "base/result.h"
#include "exit_code.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace vp::app
{

// The work of a subcommand. main() runs it after the command line has been read, and reports its error.
using Run = std::function<Result<ExitCode>()>;

// All subcommands, in the order of the help. Each function is in a file of its own, and adds its subcommand, with its
// options and help, to the program.
#define VP_COMMANDS(X)                                                                                                 \
	X(addInfo)                                                                                                         \
	X(addSlice)                                                                                                        \
	X(addRender)                                                                                                       \
	X(addSweep)                                                                                                        \
	X(addProfile)                                                                                                      \
	X(addView)                                                                                                         \
	X(addVerify)                                                                                                       \
	X(addCheck)                                                                                                        \
	X(addSample)                                                                                                       \
	X(addConvert)                                                                                                      \
	X(addManual)

#define VP_DECLARE(add) void add(CLI::App& program, Run& run);
VP_COMMANDS(VP_DECLARE)
#undef VP_DECLARE

} // namespace vp::app
