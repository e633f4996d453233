#pragma once

#include "grid/cell_list.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace vp::grid
{

/// VTK's types of cells with nodes between their corners, as far as a tolerance refines them.
inline constexpr std::uint8_t kQuadraticTetra = 24;
inline constexpr std::uint8_t kQuadraticHexahedron = 25;
inline constexpr std::uint8_t kQuadraticWedge = 26;
inline constexpr std::uint8_t kQuadraticPyramid = 27;
inline constexpr std::uint8_t kTriQuadraticHexahedron = 29;
inline constexpr std::uint8_t kQuadraticLinearWedge = 31;
inline constexpr std::uint8_t kBiQuadraticQuadraticWedge = 32;
inline constexpr std::uint8_t kBiQuadraticQuadraticHexahedron = 33;
inline constexpr std::uint8_t kLagrangeTetra = 71; // with 10 nodes, the same as a quadratic one
inline constexpr std::uint8_t kLagrangeHexahedron = 72;
inline constexpr std::uint8_t kLagrangeWedge = 73;
inline constexpr std::uint8_t kBezierTetra = 78;
inline constexpr std::uint8_t kBezierHexahedron = 79;
inline constexpr std::uint8_t kBezierWedge = 80;

inline constexpr int kMaxDegree = 10;
inline constexpr int kTetraWithMiddles = 15; // nodes of a Lagrange tetrahedron with nodes in its faces and inside
inline constexpr int kWedgeWithMiddles = 21; // the same of a wedge

constexpr bool isBezier(std::uint8_t type)
{
	return type >= kBezierTetra && type <= kBezierWedge;
}
/// Returns true for types with any number of nodes.
constexpr bool hasDegrees(std::uint8_t type)
{
	return isBezier(type) || (type >= kLagrangeTetra && type <= kLagrangeWedge);
}
constexpr bool isCurved(std::uint8_t type)
{
	return hasDegrees(type) || (type >= kQuadraticTetra && type <= kQuadraticPyramid) ||
	       type == kTriQuadraticHexahedron ||
	       (type >= kQuadraticLinearWedge && type <= kBiQuadraticQuadraticHexahedron);
}

/// Returns the shape that the corners have. isCurved() or isSliceable() must be true.
CellShape cornerShape(std::uint8_t type);

/// Returns the type of a linear cell with this shape, which is no polyhedron.
std::uint8_t linearType(CellShape shape);

/// Returns the number of nodes of a curved type, 0 where hasDegrees() is true.
int fixedNodes(std::uint8_t type);

/// Returns the number of nodes of a Lagrange or Bezier cell, 0 if there is no such cell: degrees are 1 to kMaxDegree,
/// and equal along the axes of a triangle or a tetrahedron.
std::size_t nodesOf(std::uint8_t type, const std::array<int, 3>& degrees);

/// Returns the degree of a Lagrange or Bezier cell with this number of nodes that is the same along all axes.
std::optional<int> degreeOf(std::uint8_t type, std::size_t nodes);

/// Returns true if a cell has nodes in the middle of its triangles, so that its number of nodes does not tell its
/// degree.
constexpr bool hasMiddles(std::uint8_t type, std::size_t nodes)
{
	return (type == kLagrangeTetra && nodes == kTetraWithMiddles) ||
	       (type == kLagrangeWedge && nodes == kWedgeWithMiddles);
}

} // namespace vp::grid
