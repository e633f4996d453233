#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::grid
{

// The built-in data sets. Each has the scalar s = sin(3x) cos(2y) + z/2 and the vector v = (-y, x, 0.3) on its points.
struct Demo
{
	const char* name;
	const char* about;
};

const std::vector<Demo>& demos();

// Returns a data set with n cells each way, 1 <= n <= kMaxDemoCells. If the name is unknown or n is out of range,
// returns an input error that lists the data sets.
constexpr int kMaxDemoCells = 1024;
// builds_neighbors: if false, unstructured cells are only listed (unstructured.h).
Result<BlockSet> makeDemo(std::string_view name, int n, bool builds_neighbors = true);

// The same from a text "NAME" or "NAME:N", as it follows demo: on the command line. Without N there are 64 cells each
// way.
Result<BlockSet> parseDemo(std::string_view text, bool builds_neighbors = true);

} // namespace vp::grid
