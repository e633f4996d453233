#pragma once

#include "base/messages.h"
#include "base/result.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace vp::app
{

// A message of the engine names settings by their keys, as in "`color_by` array"; here they get the names of the
// options: "--color-by array".
std::string withOptionNames(std::string_view message);

// The name that stands before lines; "vprobe" where nothing else is set.
void setProgramName(std::string name);

// A line on standard error, "vprobe: LINE", with the names of options. Standard output belongs to results. Any thread.
void printLine(std::string_view line);

// Text on standard error. Where it cannot be written (closed, full, its reader gone) nothing else changes: no error,
// and no signal.
void printError(std::string_view text);

// A result on standard output. Failures are kept by the stream, and flushOutput() tells them.
template <class... Args>
void print(fmt::format_string<Args...> format, Args&&... args)
{
	const std::string text = fmt::format(format, std::forward<Args>(args)...);
	std::fwrite(text.data(), 1, text.size(), stdout);
}

// At the program's end. An error if any of the results could not be written.
Status flushOutput();

// Call it first in main(). Where one of the three standard streams is closed, the next file that is opened would take
// its place, and lines would go into it. Here a closed one is taken up by nothing: what is written to it as a result
// fails, and lines are lost.
void fillClosedStreams();

} // namespace vp::app
