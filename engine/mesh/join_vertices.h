#pragma once

#include "grid/block.h"
#include "mesh/hanging_vertices.h"
#include "mesh/sheet_mesh.h"

namespace vp::mesh
{

// Makes one vertex of those that are one place under several names, so that what closes up in space closes up in the
// mesh: edges cut at the same grid point; edges that lie on each other at a seam; and, between several blocks, vertices
// at exactly the same place.
//
// A join changes neither the place nor a value of a corner, but for rounding: figures are those of the cells' own
// polygons. So vertices stay apart if their places or any of their point arrays differ; those of a seam are then listed
// in mesh.seam_pairs. Vertices out of use stay in the mesh.
//
// A plane cuts an edge of a seam once, whatever rounding and tolerance make of the place.
//
// Where a cell meets several smaller ones, its polygon gets corners where they have vertices (hanging_vertices.h).
//
// Returns whether vertices were joined, linked, or put into mesh.seam_pairs.
bool joinVertices(const grid::BlockSet& blocks, SheetMesh& mesh, Hanging hanging = Hanging::keep);

// The same for faces of cells and other surfaces along the grid, which meet at some seams. They lie at places of their
// own along the edges of a seam, and are joined at equal ones only; also within a block that meets itself, where faces
// about a point may have none of the seam's between them. Nothing hangs.
void joinVerticesOfFaces(const grid::BlockSet& blocks, const grid::Interfaces& seams, SheetMesh& mesh);

} // namespace vp::mesh
