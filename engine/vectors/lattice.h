#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"

#include <cstdint>
#include <vector>

namespace vp::vectors
{

// The start of a particle.
struct Launch
{
	Vec3 position{0.0};
	std::uint32_t block = 0;
	CellId cell = kNoCell;  // a cell at the position, or a few cells away; kNoCell: search for it
	std::uint32_t seed = 0; // its place in the lattice; it does not depend on which other places are in the cut
	bool inside = true;     // the position is inside a polygon of the cut; else beside one, by rounding
};

struct LatticeChoice
{
	int along = 20;      // points along the longer side, 1 or more
	double jitter = 0.0; // 0: regular; 1: anywhere in the square of the lattice
};

struct SheetLattice
{
	double spacing = 0.0; // in the grid's units; 0 if nothing is cut
	std::vector<Launch> launches;
};

// Returns points on the cut of a sheet (content: the sheet of which the mesh is the cut), in a square lattice along its
// x axis and up. The lattice covers the window, or the bounds of the cut if there is no window. Only points in the cut
// are returned. The jitter depends only on the place in the lattice, so points move with the sheet and do not tremble.
SheetLattice launchLattice(const mesh::SheetMesh& mesh, const probe::Sheet& content, const LatticeChoice& choice);
// The same over an area, of a mesh that may be a part of the cut.
SheetLattice launchLattice(const mesh::SheetMesh& mesh, const probe::Sheet& content, const LatticeChoice& choice,
                           const probe::Window& area);

// The area of the lattice where there is no window. The mesh has polygons.
probe::Window boundsInPlane(const mesh::SheetMesh& mesh, const probe::Sheet& content);

} // namespace vp::vectors
