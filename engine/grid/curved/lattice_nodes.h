#pragma once

#include <array>
#include <vector>

namespace vp::grid
{

/// A place in the lattice of a Lagrange or Bezier cell: i, j, k from 0 to the degree.
using LatticePlace = std::array<int, 3>;

/// How a writer lists the nodes within the faces of a wedge, and the nodes inside it.
struct WedgeHabit
{
	bool rings;  // triangles: corners, edges, and what is left likewise, as in a Lagrange triangle; else row by row
	bool upward; // the face between corners 2, 0, 3, 5: from corner 0 to corner 2
};

/// VTK 9.1 and PyFR.
inline constexpr WedgeHabit kVtkWedge{false, false};

/// The places of the nodes, in the order of VTK's file formats since 9.1: corners, edges, faces, inside.
std::vector<LatticePlace> tetrahedronNodes(int degree);
std::vector<LatticePlace> wedgeNodes(int across, int along, const WedgeHabit& habit = kVtkWedge);
std::vector<LatticePlace> hexahedronNodes(const std::array<int, 3>& degrees);

} // namespace vp::grid
