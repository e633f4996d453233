#pragma once

#include "pack_division.h"

#include <string>
#include <vector>

namespace vp::reader::convert
{

// Tells the user if cuts through a file whose values lie in the order of the grid's points and cells read nearly all of
// them: an oblique plane through the middle needs more than four fifths of their pages, in the mean of three planes.
// Not for small files.
std::vector<std::string> linesAboutOrder(const PackDivision& division);

} // namespace vp::reader::convert
