#pragma once

#include "cases/lattice_cases.h"
#include "mesh/sheet_mesh.h"

#include <array>
#include <cstdint>

namespace vp::mesh
{

// The numbers of the up to three vertices that a point owns, along i, j and k. A vertex that is not there has the
// number of the next one.
struct OwnedVertices
{
	std::uint32_t along[4]; // the fourth is not used: a power of two is found by a shift
};

// Where the corners of a cell's polygon stand: in the vertices of one of the four rows of points along the cell,
// counted from the column where the cell begins. Places behind the corners repeat the first.
struct alignas(16) CornerPlaces
{
	std::array<std::uint8_t, cases::kMaxLatticeEdges> row;
	std::array<std::uint8_t, cases::kMaxLatticeEdges> number;
	std::uint8_t corners; // 0: the cell has no polygon by the table
};

using CornerTable = std::array<CornerPlaces, cases::kColumnCases>; // by case; empty where a cell is left out

// In the opposite order where `turned`.
const CornerTable& cornerTable(bool turned);

// Four numbers, computed in one step where the processor can.
using FourNumbers = std::uint32_t __attribute__((vector_size(16)));

// How many of the edges that a point owns are cut, along no axis, i, i and j, and all three.
struct OwnedEdges
{
	FourNumbers up_to{};
	std::array<std::uint32_t, 4> bytes{}; // the same in the edges of a mesh
};

using OwnedTable = std::array<OwnedEdges, cases::kColumnCases>; // by case, of the point where the cell begins

const OwnedTable& ownedTable();

} // namespace vp::mesh
