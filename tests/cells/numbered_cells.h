#pragma once

#include "base/vec.h"
#include "unit_cube.h"

#include <array>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

// Cells whose nodes are numbered here, by what the format's description says, and not by the library that is tested.

struct NumberedCell
{
	std::string name;
	std::uint8_t type; // VTK's
	ParentShape shape;
	// Place in a cube, half a cube (x + y <= 1), a corner of the cube (x + y + z <= 1), or the pyramid on the unit
	// square with its top at (1/2, 1/2, 1).
	std::vector<vp::Vec3> nodes;
	std::array<int, 3> degrees = {0, 0, 0}; // written where they are not 0
	int intervals = 1;                      // linear parts along an edge
	bool is_bezier = false;

	int degree() const { return std::max({degrees[0], degrees[1], degrees[2]}); }
};

std::ostream& operator<<(std::ostream& out, const NumberedCell& cell);

enum class Family
{
	lagrange,
	bezier
};

// How a writer numbers hexahedra and wedges.
struct Habit
{
	bool swaps_edges = false; // hexahedra: before VTK 9.1
	bool upward = false;      // wedges: before VTK 9.1
	bool rings = false;       // wedges: triangles as in Lagrange triangles
};

NumberedCell tetrahedronOf(Family family, int degree);
NumberedCell wedgeOf(Family family, int across, int along, const Habit& habit = {});
NumberedCell hexahedronOf(Family family, std::array<int, 3> degrees, const Habit& habit = {});
std::vector<NumberedCell> quadraticCells();
std::vector<NumberedCell> linearCells();

// A unit cube of count^3 blocks, each one hexahedron, 2 wedges, or 6 tetrahedra or pyramids, conforming.
struct CubeMesh
{
	std::vector<vp::Vec3> points;
	std::vector<double> weights; // rational; empty where there are none
	std::vector<double> values;  // point array "f"
	std::vector<std::vector<std::size_t>> cells;
	std::uint8_t type;
	std::array<int, 3> degrees;
};
CubeMesh cubeOf(const NumberedCell& cell, int count);

// Moves every point. The points of a Bezier cell are handles, so there this is exact for straight maps only.
void movePoints(CubeMesh& mesh, const std::function<vp::Vec3(vp::Vec3)>& map);
void setValues(CubeMesh& mesh, const std::function<double(vp::Vec3)>& value);

// As text. `version` is the file's: the library takes hexahedra of XML files below 2.1, and of legacy files below 5.1,
// in the numbering of before VTK 9.1.
void writeXml(const CubeMesh& mesh, const std::string& path, const std::string& version = "2.2", int pieces = 1);
void writeLegacy(const CubeMesh& mesh, const std::string& path, const std::string& version = "5.1");
