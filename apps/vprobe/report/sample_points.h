#pragma once

#include "base/result.h"
#include "base/vec.h"

#include <string>
#include <vector>

namespace vp::app
{

// Reads points from a text file. Each line has three finite numbers, separated by blanks, commas or semicolons, in
// every spelling of base/real_text.h. Empty lines and what follows a # are skipped. The first line may be a header; if
// it names columns x, y and z, they are taken, and the other ones may hold anything. So what vprobe sample writes can
// be read. The name "-" means standard input. Any other line is an input error, which names the file and the line.
Result<std::vector<Vec3>> readPoints(const std::string& path);

// Returns N points that are evenly spread along a line, both ends included. numbers: x0 y0 z0 x1 y1 z1 N, as --line
// takes them. Returns a usage error if they cannot be a line.
Result<std::vector<Vec3>> pointsOnLine(const std::vector<double>& numbers);

} // namespace vp::app
