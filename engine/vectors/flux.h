#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/sheet_mesh.h"

namespace vp::vectors
{

// The flow through a sheet, in the unit of the vectors times that of an area.
struct Flux
{
	double through = 0.0;  // integral of vector times unit normal; positive toward the side of the normal
	double nan_area = 0.0; // the part of the sheet where the vector is NaN, infinite or unknown; it is left out
};

// array: of three components (chooseVectors()). Through the polygons of a mesh, which a window has clipped, each as the
// fan of triangles about the mean of its vertices, whose vector is the mean of theirs: exact for linear fields.
// Boundary faces in the plane are left out, as in measure::measure().
Flux fluxThrough(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const grid::FieldChoice& array);

} // namespace vp::vectors
