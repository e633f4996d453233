#pragma once

#include "base/result.h"
#include "base/vec.h"

#include <string>
#include <vector>

namespace vp::app
{

// Points of a text file, a line of three finite numbers each, parted by blanks or commas; empty lines count for
// nothing.
// "-" is standard input. Another line is an input error that names file and line.
Result<std::vector<Vec3>> readPoints(const std::string& path);

// So many points, evenly spread, both ends among them. numbers: x0 y0 z0 x1 y1 z1 N, as of --line; a usage error where
// they cannot be.
Result<std::vector<Vec3>> pointsOnLine(const std::vector<double>& numbers);

} // namespace vp::app
