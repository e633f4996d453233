#pragma once

#include <string>

namespace vp::app
{

/// Says in one line why the program ends where it crashes, and removes unfinished files. If the crash lies in the
/// driver of a device, or in LLVM, by which lavapipe makes code, the line names `--device`, and the exit code is 3. Any
/// other crash ends the program by its own signal, as it would without this. Also for exceptions that nobody catches.
/// For programs only, in main: a library does not touch the signals of its host. Sanitizers keep their own handlers.
void sayLastWord(const std::string& program);

} // namespace vp::app
