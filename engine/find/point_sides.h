#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/unstructured.h"
#include "surface/curved.h"
#include "surface/plane.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::find
{

// The side of a surface on which a point lies: bits, so that those of a cell are joined by one operation for each
// point.
inline constexpr std::uint8_t kPositive = 1;
inline constexpr std::uint8_t kNegative = 2;
inline constexpr std::uint8_t kInSurface = 4; // and positive
inline constexpr std::uint8_t kNoPoint = 8;   // what a wrong id names

/// Write the sides of the points from `begin` to `end`. bounds: of the cells. Beyond them a side may be wrong, but no
/// cell has points there.
void takeSides(const grid::UnstructuredGrid& grid, const surface::Plane& plane, const Box& bounds, std::size_t begin,
               std::size_t end, std::uint8_t* sides);
void takeSides(const grid::UnstructuredGrid& grid, const surface::BlockSurface& surface, const Box& bounds,
               std::size_t begin, std::size_t end, std::uint8_t* sides);

/// The same for some points, each at its place in `sides`. Other threads may do it for the same points at the same
/// time.
void takeSides(const grid::UnstructuredGrid& grid, const surface::Plane& plane, std::span<const PointId> points,
               std::uint8_t* sides);
void takeSides(const grid::UnstructuredGrid& grid, const surface::BlockSurface& surface,
               std::span<const PointId> points, std::uint8_t* sides);

} // namespace vp::find
