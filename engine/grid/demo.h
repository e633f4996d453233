#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::grid
{

// The built-in data sets, each with scalar s = sin(3x) cos(2y) + z/2 and vector v = (-y, x, 0.3) on its points.
struct Demo
{
	const char* name;
	const char* about;
};

const std::vector<Demo>& demos();

// n cells each way, 1 <= n <= kMaxDemoCells. An unknown name, or an n out of range, is an input error that lists what
// there is.
constexpr int kMaxDemoCells = 1024;
// builds_neighbors: else unstructured cells are listed (unstructured.h).
Result<BlockSet> makeDemo(std::string_view name, int n, bool builds_neighbors = true);

// "NAME" or "NAME:N" (64 cells when N is left out), as after demo: on the command line.
Result<BlockSet> parseDemo(std::string_view text, bool builds_neighbors = true);

} // namespace vp::grid
