#pragma once

#include "base/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

// An octahedron among the parts of a cell: its points are the edge midpoints of a tetrahedron, in the order of a
// quadratic tetrahedron's. It is cut into four tetrahedra along one of its diagonals.
constexpr std::uint8_t kOctahedron = 255;

// How one kind of cell is cut into linear ones. A node is a point of the cell, or lies in the middle of some of its
// points: of an edge (2), of a face (4) or of the whole (8).
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

// Hexahedra, wedges and tetrahedra over a lattice of so many intervals along their axes; `at` gives each point's place
// in it, from 0 to 1. Only lattices of two intervals may lack points.
CellSplit splitHexahedron(std::array<int, 3> intervals, std::span<const vp::Vec3> at);
CellSplit splitWedge(int across, int along, std::span<const vp::Vec3> at);
CellSplit splitTetrahedron(int intervals, std::span<const vp::Vec3> at);

// The cells with points in the middle of triangles. VTK fans the faces of the first two about those points.
CellSplit splitWedge21();
CellSplit splitTetrahedron15();
CellSplit splitPyramid19();

// Of 5 or 13 points.
CellSplit splitPyramid(int points);

// Of the parts themselves, each edge halved.
const CellSplit& halvedSplit(std::uint8_t type);

int pointsOf(std::uint8_t part_type);

// Four tetrahedra about diagonal 0, 1 or 2 of an octahedron, and that diagonal's ends.
using OctahedronCut = std::array<std::array<std::uint8_t, 4>, 4>;
const OctahedronCut& octahedronCut(int diagonal);
constexpr std::array<std::array<std::uint8_t, 2>, 3> kOctahedronDiagonals = {{{0, 5}, {1, 3}, {2, 4}}};
