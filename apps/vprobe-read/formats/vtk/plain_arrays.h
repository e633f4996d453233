#pragma once

#include "vprobe-read/arrays/plain_array.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::vtk
{

// Returns the plain arrays of a VTKHDF file of one unstructured grid. Throws a Refusal if HDF5 cannot read it.
std::vector<arrays::PlainArray> plainArraysOfHdf(const std::string& file);

// Returns those of a binary legacy file, whose text this is. Throws a Refusal if it is damaged.
std::vector<arrays::PlainArray> plainArraysOfLegacy(std::string_view text);

} // namespace vp::reader::vtk
