#pragma once

#include "grid/cell_places.h"

#include <optional>

namespace vp::vectors
{

// Where a straight way leaves a cell.
struct LeftThrough
{
	double part; // how far along the way, 0 to 1
	int face;
};

// Follows a straight way in a cell of any form: concave, or with holes. Returns nothing if the way ends in the cell, or
// on its surface. Places are inside where grid::isEnclosed() says so, so cells that share a face agree about it.
// begun: the part of the way from which on it is followed. begins_inside: at its begin it is in the cell; else what
// lies before the cell is left out.
std::optional<LeftThrough> whereLeft(const grid::CellPlaces& cell, const Vec3& from, const Vec3& to, double begun,
                                     bool begins_inside);

} // namespace vp::vectors
