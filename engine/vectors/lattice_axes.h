#pragma once

#include "grid/structured.h"

#include <array>
#include <cstdint>

namespace vp::vectors
{

// A curvilinear grid may keep its axes in another order than its source (grid/link/lattice_axes.h), and pieces of one
// grid in several orders. What goes from one to the other has the source's.
using LatticeAxes = std::array<std::uint8_t, 3>; // per axis of the grid, that of the source

template <class G>
LatticeAxes axesOf(const G& grid)
{
	if constexpr (requires { grid.axes(); })
		return grid.axes();
	else
		return {0, 1, 2};
}

inline int sourceFace(const LatticeAxes& axes, int face)
{
	return 2 * axes[face / 2] + face % 2;
}

inline int faceOfSource(const LatticeAxes& axes, int face)
{
	for (int axis = 0; axis < 3; ++axis)
		if (axes[axis] == face / 2)
			return 2 * axis + face % 2;
	return face;
}

// Corners of a hexahedron, in VTK's order.
inline int sourceCorner(const LatticeAxes& axes, int corner)
{
	const std::array<int, 3> at{(corner & 1) ^ (corner >> 1 & 1), corner >> 1 & 1, corner >> 2};
	std::array<int, 3> source{};
	for (int axis = 0; axis < 3; ++axis)
		source[axes[axis]] = at[axis];
	return 4 * source[2] + (source[1] ? 3 - source[0] : source[0]);
}

// Coordinates in a cell.
inline Vec3 toSource(const LatticeAxes& axes, const Vec3& u)
{
	Vec3 source;
	for (int axis = 0; axis < 3; ++axis)
		source[axes[axis]] = u[axis];
	return source;
}

inline Vec3 fromSource(const LatticeAxes& axes, const Vec3& source)
{
	return {source[axes[0]], source[axes[1]], source[axes[2]]};
}

} // namespace vp::vectors
