#pragma once

#include "read/check_mesh.h"
#include "read/manifest.h"
#include "read/read_warning.h"

#include <array>
#include <cstddef>
#include <string>

namespace vp::read
{

/// Thrown if each cell of a block has a point without a place.
class NonePlaced : public Unusable
{
public:
	NonePlaced(const std::string& why, std::size_t count) : Unusable(why), cells(count) {}
	std::size_t cells;
};

/// Returns true if the coordinates of all points are finite and not larger than kMaxCoordinate.
bool areAllPlaces(const grid::Points& points);

/// Leaves out the cells that have a point without a place: they become empty cells. A point that no cell uses may lie
/// anywhere. A cell of a file that is given in parts is left out whole. Preconditions: checkCells(), checkSources().
/// Returns how many cells of the file are left out. Throws NonePlaced.
std::size_t leaveOutUnplaced(CellMesh& mesh);

/// Makes the mesh of a block of these points in the order of a lattice: a curvilinear grid, or if some points have no
/// place, an unstructured one without the cells at these points. Returns how many cells are left out. Throws
/// NonePlaced.
std::size_t takePlacedLattice(const std::array<std::uint32_t, 3>& lattice, grid::Points points, CheckedBlock& block);

/// Removes the polygons that have a point without a place. Precondition: checkPolygons().
void removeUnplaced(grid::PatchPolygons& polygons);

/// The warning that tells of cells that were left out.
ReadWarning unplacedWarning(std::size_t cells);

} // namespace vp::read
