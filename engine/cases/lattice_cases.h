#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace vp::cases
{

// The case of the cell (i, j, k) of a lattice: S at the points (j, k), (j+1, k), (j, k+1), (j+1, k+1) at i in bits 0 to
// 3, the same at i + 1 in bits 4 to 7. For the last column of a run of cells, both are those of the column.
using ColumnCase = std::uint16_t;

// Bit 8: the cell is cut, but does not count as such, since a window leaves it out.
constexpr ColumnCase kLeftOut = 1 << 8;
constexpr std::size_t kColumnCases = 2 * kLeftOut;

// A lattice edge starts at its lower point and runs along i, j or k; that point owns it.
struct LatticeEdge
{
	std::uint8_t row;  // one of the four rows of points along the cell: bit 0 is j + 1, bit 1 is k + 1
	std::uint8_t at;   // 0: at the column i, 1: at i + 1
	std::uint8_t axis; // 0, 1, 2: along i, j, k
};

constexpr int kMaxLatticeEdges = 6; // largest number of edges of one polygon

// The cut of a lattice cell, from the case table of the hexahedron.
struct LatticeCase
{
	std::uint8_t edges = 0;  // edges of its polygon; 0: nothing is cut, or the walk is needed
	bool needs_walk = false; // as in Case
	// The cut edges of the lowest point. Bit a is set if the edge that it owns along axis a is cut.
	std::uint8_t owned = 0;
	std::uint8_t owned_count = 0;
	// The edges of the polygon, counter-clockwise seen from the positive side, as in Case. Behind them the first edge
	// is repeated, so that all can be read without asking for their number.
	std::array<LatticeEdge, kMaxLatticeEdges> edge{};
};

// By case, kLeftOut aside. The point of the last column of a run owns no edge along i.
const std::array<LatticeCase, 256>& latticeCases();

} // namespace vp::cases
