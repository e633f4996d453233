#pragma once

namespace vp::app
{

// In the help of vprobe, and of vprobe-view, which shows the help of `vprobe view`.
constexpr const char* kAbout =
    "Slices of volume data on any computational grid, by volume probes (Speray and Kennon, 1990).";
constexpr const char* kFooter =
    "vprobe COMMAND --help tells a command's options. vprobe INPUT opens a window. INPUT is a file or "
    "demo:NAME[:N], N cells each way;\n"
    "vprobe info demo: lists the built-in data sets. Try: vprobe render demo:shell --normal 0.3 0.5 0.8 -o "
    "shell.png";

} // namespace vp::app
