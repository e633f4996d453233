#pragma once

#include <benchmark/benchmark.h>

#include <string>

namespace vp::bench
{

// 10 000 particles launched together from a plane through a shell's axis, 200 steps of 0.01 each. Both are measured
// with the points they give, counter "points", and with 5(4) Runge-Kutta pairs (VTK's is Cash and Karp's) whose error
// leaves the steps as they are. VTK's steps have lengths in place of times, 0.3 of a cell's: so each path is as long.
void ourTraces(benchmark::State& state, const std::string& name);
void vtkTraces(benchmark::State& state, const std::string& name);

} // namespace vp::bench
