#pragma once

#include "base/vec.h"

#include <array>
#include <vector>

enum class ParentShape
{
	tetrahedron,
	pyramid,
	wedge,
	hexahedron
};

// The place of a cell: the origin and the three edges of its reference shape.
using CellFrame = std::array<vp::Vec3, 4>;

// The cells of a unit cube: a hexahedron, 2 wedges, or 6 pyramids or tetrahedra. They part its sides alike in every
// cube. The third edge of a pyramid runs so that (1/2, 1/2, 1) comes to the cube's middle.
std::vector<CellFrame> unitCubeCells(ParentShape shape);
