#pragma once

#include "grid/block.h"
#include "mesh/build_mesh.h"
#include "mesh/sheet_mesh.h"

#include <span>

namespace vp::mesh
{

// The crinkled surface around the cells that a sheet shows, whole: those it cuts, and those whose boundary face lies in
// its plane. A face is part of it unless such a cell is on either side, in the same block or across a seam; of a face
// with several neighbors in its block all must be, and across a seam such cells must cover it. Faces wind
// counter-clockwise seen from outside their cell, and each keeps the cell it is of; vertices are grid points. Curved
// cells show the linear parts that are cut. Time follows the cut.
//
// Where the blocks know no neighbors, the faces of these cells are compared with each other. If three cells share a
// face, which no sound grid has, and only two of them are shown, the face is then left out.
SheetMesh crinkleMesh(const grid::BlockSet& blocks, std::span<const ShownBlock> shown);

} // namespace vp::mesh
