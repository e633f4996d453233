#pragma once

#include <cstdint>

namespace vp::read
{

// The cell type numbers of VTK that reading must distinguish.
constexpr std::uint8_t kEmptyCell = 0;
constexpr std::uint8_t kTetra = 10;
constexpr std::uint8_t kVoxel = 11;
constexpr std::uint8_t kHexahedron = 12;
constexpr std::uint8_t kWedge = 13;
constexpr std::uint8_t kPyramid = 14;
constexpr std::uint8_t kPolyhedron = 42;

// Returns the dimension of a cell type, -1 if VTK 9 does not know the type.
constexpr int cellDimension(std::uint8_t type)
{
	switch (type)
	{
	case 0: // empty
	case 1: // vertex
	case 2: // poly vertex
		return 0;
	case 3:  // line
	case 4:  // poly line
	case 21: // quadratic edge
	case 35: // cubic line
	case 51: // parametric curve
	case 60: // higher order edge
	case 68: // Lagrange curve
	case 75: // Bezier curve
		return 1;
	case 5:  // triangle
	case 6:  // triangle strip
	case 7:  // polygon
	case 8:  // pixel
	case 9:  // quad
	case 22: // quadratic triangle
	case 23: // quadratic quad
	case 28: // biquadratic quad
	case 30: // quadratic linear quad
	case 34: // biquadratic triangle
	case 36: // quadratic polygon
	case 52: // parametric surfaces
	case 53:
	case 54:
	case 61: // higher order triangle, quad, polygon
	case 62:
	case 63:
	case 69: // Lagrange triangle, quadrilateral
	case 70:
	case 76: // Bezier triangle, quadrilateral
	case 77:
		return 2;
	default:
		break;
	}
	const bool linear = type >= 10 && type <= 16;
	const bool quadratic = (type >= 24 && type <= 27) || type == 29 || (type >= 31 && type <= 33) || type == 37;
	const bool free_form = type == 41 || type == 42 || type == 55 || type == 56;
	const bool high_order = (type >= 64 && type <= 67) || (type >= 71 && type <= 74) || (type >= 78 && type <= 81);
	return linear || quadratic || free_form || high_order ? 3 : -1;
}

// Returns the number of points of a three-dimensional cell that can be cut. Returns 0 for a polyhedron, which can have
// any number, and for all other types.
constexpr int slicedCellSize(std::uint8_t type)
{
	switch (type)
	{
	case kTetra:
		return 4;
	case kVoxel:
	case kHexahedron:
		return 8;
	case kWedge:
		return 6;
	case kPyramid:
		return 5;
	default:
		return 0;
	}
}

constexpr bool canBeSliced(std::uint8_t type)
{
	return slicedCellSize(type) > 0 || type == kPolyhedron;
}

} // namespace vp::read
