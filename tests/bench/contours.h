#pragma once

#include <benchmark/benchmark.h>

#include <string>

namespace vp::bench
{

// The value that is had in the middle of a sheet across a data set's middle, in a box of 1/10 of each side of its
// bounds. Counter "cells".
void boxContour(benchmark::State& state, const std::string& name, bool with_sheet); // the sheet is cut anew each time

// Contours the same value everywhere with vtkContourFilter. Counter "triangles".
void vtkContour(benchmark::State& state, const std::string& name);

} // namespace vp::bench
