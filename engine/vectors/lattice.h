#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"

#include <cstdint>
#include <vector>

namespace vp::vectors
{

// Where a particle starts.
struct Launch
{
	Vec3 position{0.0};
	std::uint32_t block = 0;
	CellId cell = kNoCell;  // that holds the position, or is a few cells away; kNoCell: it is looked for
	std::uint32_t seed = 0; // its place in the lattice, the same whatever other places are in the cut
};

struct LatticeChoice
{
	int along = 20;      // points along the longer side, 1 or more
	double jitter = 0.0; // 0: regular; 1: anywhere in its square of the lattice
};

struct SheetLattice
{
	double spacing = 0.0; // in the grid's units; 0 where nothing is cut
	std::vector<Launch> launches;
};

// Points on the cut of a sheet (content: the one that the mesh is the cut of), in a square lattice along its x axis and
// up: over its window, or the bounds of its cut where it has none. Only those that lie in the cut. The jitter of a
// point follows from its place in the lattice alone, so points move with the sheet and do not tremble.
SheetLattice launchLattice(const mesh::SheetMesh& mesh, const probe::Sheet& content, const LatticeChoice& choice);

} // namespace vp::vectors
