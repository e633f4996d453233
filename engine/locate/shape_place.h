#pragma once

#include "base/vec.h"
#include "grid/cell_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::locate
{

// Places in the own coordinates of a table shape, each from 0 to 1, as in VTK's shape functions. A pyramid has
// a = r (1 - t), b = s (1 - t), t instead (see interpolate.cpp).

inline Vec3 middleOf(grid::CellShape shape)
{
	switch (shape)
	{
	case grid::CellShape::tetrahedron:
		return Vec3(0.25);
	case grid::CellShape::pyramid:
		return {0.4, 0.4, 0.2};
	case grid::CellShape::wedge:
		return {1.0 / 3.0, 1.0 / 3.0, 0.5};
	default:
		return Vec3(0.5);
	}
}

// The depth of a place behind each face of grid::topology(shape), negative outside. Entries beyond the shape's faces
// are infinite.
struct FaceDepths
{
	std::array<double, grid::kMaxShapeFaces> of;

	double least() const { return std::min({of[0], of[1], of[2], of[3], of[4], of[5]}); }
};

inline FaceDepths faceDepths(grid::CellShape shape, const Vec3& u)
{
	constexpr double kNone = HUGE_VAL;
	switch (shape)
	{
	case grid::CellShape::tetrahedron:
		return {{u.y, 1.0 - u.x - u.y - u.z, u.x, u.z, kNone, kNone}};
	case grid::CellShape::pyramid:
		return {{u.z, u.y, 1.0 - u.z - u.x, 1.0 - u.z - u.y, u.x, kNone}};
	case grid::CellShape::wedge:
		return {{u.z, 1.0 - u.z, u.y, 1.0 - u.x - u.y, u.x, kNone}};
	default:
		return {{u.x, 1.0 - u.x, u.y, 1.0 - u.y, u.z, 1.0 - u.z}};
	}
}

} // namespace vp::locate
