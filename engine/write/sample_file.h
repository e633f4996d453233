#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "grid/block.h"
#include "grid/field_choice.h"

#include <cstddef>
#include <span>
#include <string>

namespace vp::write
{

// The values of arrays at points as CSV, a row each in their order: x, y, z, block, cell (as the file numbers them,
// from 0), then the arrays, named as writeSlice() names them. Point arrays are interpolated in the cell
// (locate/interpolate.h), categorical ones take the point that counts most; cell arrays are the cell's. Of a point
// outside the grid block and cell are empty and the values nan. chosen: the arrays, whatever their component; none:
// all. "-" is standard output. Gives how many points are outside.
Result<std::size_t> writeSamples(const grid::BlockSet& blocks, std::span<const Vec3> points,
                                 std::span<const grid::FieldChoice> chosen, const std::string& path);

} // namespace vp::write
