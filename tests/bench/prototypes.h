#pragma once

#include <benchmark/benchmark.h>

#include <optional>
#include <string>

namespace vp::bench
{

// Returns the command that runs the prototype for a grid, such as "shell:256"; nothing if the prototypes were not built
// (VPROBE_PROTOTYPES) or none cuts such a grid.
std::optional<std::string> prototypeOf(const std::string& grid);

// Runs a prototype, and takes its time for a plane of the same sweep: its time for a cut cell times the number of cells
// that this program cuts.
void prototypeCut(benchmark::State& state, const std::string& grid, const std::string& command);

} // namespace vp::bench
