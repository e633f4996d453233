#pragma once

#include "grid/cell_shape.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::refine
{

/// Splits a linear cell into tetrahedra about the corner with the lowest id, quadrilaterals along the diagonal from
/// their lowest id: so both cells of a face split it alike. Tetrahedra with a corner twice are left out, as of
/// collapsed cells. They are not all turned alike.
void splitCorners(grid::CellShape shape, std::span<const std::uint32_t> ids,
                  std::vector<std::array<std::uint8_t, 4>>& tetrahedra);

} // namespace vp::refine
