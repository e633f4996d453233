#pragma once

#include "grid/block.h"
#include "mesh/hanging_vertices.h"
#include "mesh/sheet_mesh.h"

namespace vp::mesh
{

// Makes one vertex of those that are one place under several names, so that what closes up in space closes up in the
// mesh: edges cut at the same grid point; edges that lie on each other at a seam; and, between several blocks, vertices
// at exactly the same place. Vertices whose point arrays differ stay apart, so that a jump of the data survives; those
// of a seam are then listed in mesh.seam_pairs. Vertices out of use stay in the mesh.
//
// A plane cuts an edge of a seam once, whatever rounding and tolerance make of the place. What is given `by_place`
// lies, as grid surfaces of two blocks do, at places of its own along such an edge, and is joined at equal ones only;
// also within a block that meets itself, where faces about a point may have none of the seam's between them.
//
// Where a cell meets several smaller ones, both sides have the same vertices afterwards, if both have the same point
// arrays (hanging_vertices.h). Else the sides are listed in mesh.seam_pairs alone. By place, nothing hangs.
//
// Returns whether vertices were joined, linked, or put into mesh.seam_pairs.
bool joinVertices(const grid::BlockSet& blocks, SheetMesh& mesh, bool by_place = false,
                  Hanging hanging = Hanging::keep);

} // namespace vp::mesh
