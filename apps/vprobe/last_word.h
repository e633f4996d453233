#pragma once

#include <string_view>

namespace vp::app
{

/// Says in one line why the program ends where it crashes, and removes unfinished files. If the crash lies in the
/// driver of a device, or in LLVM, by which lavapipe makes code, the line names `--device`, and the exit code is 3. Any
/// other crash ends the program by its own signal, as it would without this. Also for exceptions that nobody catches.
/// If the program aborts since memory ran out where no error can be passed on, as in a destructor, it has exit code 4.
/// For programs only, in main: a library does not touch the signals of its host. Sanitizers keep their own handlers.
void sayLastWord(std::string_view program);

/// The end of the line that says so. A program that runs out of memory has exit code 4.
inline constexpr std::string_view kOutOfMemory = "out of memory; use a smaller input or a machine with more memory";

/// Says in one line that memory ran out, and asks for none. It needs no sayLastWord() before, but for the name.
void sayOutOfMemory() noexcept;

} // namespace vp::app
