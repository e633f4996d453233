#pragma once

#include <array>
#include <cstdint>

namespace vp::cases
{

// A column of a lattice at i: the S bits of the points (j, k), (j+1, k), (j, k+1), (j+1, k+1) in bits 0 to 3. The cell
// (i, j, k) lies between the columns at i and i + 1, which make its case index.
using Column = std::uint8_t;

// Bit 4 of a column: the cell that begins there is cut, but does not count as such, since a window leaves it out.
constexpr Column kLeftOut = 1 << 4;

constexpr bool isUniform(Column column)
{
	return column == 0 || column == 15;
}

constexpr unsigned caseIndex(Column at, Column next)
{
	return (at & 15u) | (next & 15u) << 4;
}

// A lattice edge starts at its lower point and runs along i, j or k; that point owns it.
struct LatticeEdge
{
	std::uint8_t row;  // of the four rows of points along the cell: bit 0 is j + 1, bit 1 is k + 1
	std::uint8_t at;   // 0: at the column i, 1: at i + 1
	std::uint8_t axis; // 0, 1, 2: along i, j, k
};

constexpr int kMaxLatticeEdges = 6; // of one polygon

// The cut of a lattice cell, from the case table of the hexahedron.
struct LatticeCase
{
	std::uint8_t edges = 0;     // of its polygon; 0: nothing is cut, or the walk is needed
	bool needs_walk = false;    // as in Case
	std::uint8_t row_faces = 0; // bits 0 to 3: the faces -j, +j, -k, +k are cut
	// Of the lowest point: bit a: the edge that it owns along axis a is cut.
	std::uint8_t owned = 0;
	std::uint8_t owned_count = 0;
	// The edges of the polygon, counter-clockwise seen from the positive side, as in Case. Behind them the first edge
	// is repeated, so that all can be read without asking for their number.
	std::array<LatticeEdge, kMaxLatticeEdges> edge{};
};

// By case index; caseIndex(last, last) for the last column of a row, whose point owns no edge along i.
const std::array<LatticeCase, 256>& latticeCases();

} // namespace vp::cases
