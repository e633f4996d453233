#pragma once

#include "lattice_sets.h"

namespace vp::test
{

// A cell among its neighbors, warped so that a plane cuts it with given signs.
struct TwistedSet
{
	RawSet raw;
	std::size_t cell; // its source number in block 0
	TestPlane plane;  // the same for every mask and seed
};

// Bit p of the mask: point p of the cell, in its order (of a polyhedron in ascending order), is on the positive side.
// For lattices and cells of one shape, and polyhedra.
TwistedSet twistedSet(LatticeKind kind, std::uint32_t mask, unsigned seed);

int twistedPoints(LatticeKind kind); // number of points of the cell

} // namespace vp::test
