#pragma once

#include "base/result.h"
#include "exit_code.h"

#include <CLI/CLI.hpp>

#include <functional>

namespace vp::app
{

// The work of a subcommand. main() runs it after the command line has been read, and reports its error.
using Run = std::function<Result<ExitCode>()>;

// All subcommands, in the order of the help. Each name has a function, which is in a file of its own, and adds its
// subcommand, with its options and help, to the program.
#define VP_COMMANDS(X)                                                                                                 \
	X("info", addInfo)                                                                                                 \
	X("slice", addSlice)                                                                                               \
	X("render", addRender)                                                                                             \
	X("sweep", addSweep)                                                                                               \
	X("profile", addProfile)                                                                                           \
	X("view", addView)                                                                                                 \
	X("verify", addVerify)                                                                                             \
	X("check", addCheck)                                                                                               \
	X("sample", addSample)                                                                                             \
	X("convert", addConvert)                                                                                           \
	X("pack", addPack)                                                                                                 \
	X("index", addIndex)                                                                                               \
	X("manual", addManual)

#define VP_DECLARE(name, add) void add(CLI::App& program, Run& run);
VP_COMMANDS(VP_DECLARE)
#undef VP_DECLARE

} // namespace vp::app
