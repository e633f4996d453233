#pragma once

#include <string>
#include <vector>

namespace vp::app
{

/// Goes on as vprobe-view, which has the window, if the first of the arguments is the command `view`. That program lies
/// beside this one, or in its libexec folder. It takes the place of this one in the same process, with the same
/// arguments, streams and signals. Returns for other commands, and where vprobe-view is not installed.
///
/// So GLFW and X11 are loaded by the window alone.
void becomeViewer(const char* called, const std::vector<std::string>& arguments);

} // namespace vp::app
