#pragma once

#include "ensight_geometry.h"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace vp::reader::meshes
{

// Values of a variable by the numbers of the parts, tuple by tuple; NaN where the file has none. Symmetric tensors have
// VTK's order: xx, yy, zz, xy, yz, xz.
using EnSightValues = std::map<std::int64_t, std::vector<double>>;

// Throws a Refusal if the file is damaged. `components`: 1, 3, 6 or 9.
EnSightValues readEnSightValues(const EnSightFile& file, std::string_view step, const EnSightGeometry& geometry,
                                bool per_node, int components);

} // namespace vp::reader::meshes
