#pragma once

#include "base/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::cells
{

// An octahedron among the parts of a cell: its points are the edge midpoints of a tetrahedron, in the order of a
// quadratic tetrahedron's. It is cut into four tetrahedra along one of its diagonals.
constexpr std::uint8_t kOctahedron = 255;

// Says how one kind of cell is split into linear ones. A node is a point of the cell, or the middle of some of its
// points: of an edge (2), a face (4) or the whole cell (8).
struct CellSplit
{
	struct Node
	{
		int point = -1;
		int corner_count = 0;
		std::array<std::uint8_t, 8> corners = {}; // points of the cell
	};
	struct Part
	{
		std::uint8_t type; // VTK's of a linear cell, or kOctahedron
		std::array<std::uint16_t, 8> nodes = {};
	};
	std::vector<Node> nodes;
	std::vector<Part> parts;
};

// These split a cell over a lattice with so many intervals along its axes. `at` has the place of each point, from 0 to
// 1. Only lattices of two intervals may lack points.
CellSplit splitHexahedron(std::array<int, 3> intervals, std::span<const Vec3> at);
CellSplit splitWedge(int across, int along, std::span<const Vec3> at);
CellSplit splitTetrahedron(int intervals, std::span<const Vec3> at);

// These split cells with points in the middle of triangles. VTK fans faces about those points.
CellSplit splitWedge21();
CellSplit splitTetrahedron15();
CellSplit splitPyramid19();

// Splits a pyramid of 5 or 13 points.
CellSplit splitPyramid(int points);

// Splits a linear part by halving each edge.
const CellSplit& halvedSplit(std::uint8_t type);

int pointsOf(std::uint8_t part_type);

// Four tetrahedra about diagonal 0, 1 or 2 of an octahedron.
using OctahedronCut = std::array<std::array<std::uint8_t, 4>, 4>;
const OctahedronCut& octahedronCut(int diagonal);
constexpr std::array<std::array<std::uint8_t, 2>, 3> kOctahedronDiagonals = {{{0, 5}, {1, 3}, {2, 4}}};

} // namespace vp::reader::cells
