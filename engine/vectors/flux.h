#pragma once

#include "base/exact_sum.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/sheet_mesh.h"

namespace vp::vectors
{

// The flow through a sheet, in the unit of the vectors times that of an area.
struct Flux
{
	double through = 0.0;  // integral of vector times unit normal; positive toward the side of the normal
	double boundary = 0.0; // the same through the boundary faces in the plane, which are no part of the rest
	double nan_area = 0.0; // the part of the sheet where the vector is NaN, infinite or unknown; it is left out
};

// The same of a part of a sheet, exact, so that parts may be added in any order. A plain struct, which may be sent as
// bytes.
struct FluxSums
{
	ExactSum through;
	ExactSum boundary;
	ExactSum nan_area;

	void add(const FluxSums& other);
	Flux flux() const { return {through.value(), boundary.value(), nan_area.value()}; }
};

// array: of three components (chooseVectors()). Through the polygons of a mesh, which a window has clipped, each as the
// fan of triangles about the mean of its vertices, whose vector is the mean of theirs: exact for linear fields.
// Boundary faces in the plane are summed by themselves, as in measure::measure().
Flux fluxThrough(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const grid::FieldChoice& array);
FluxSums fluxSums(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const grid::FieldChoice& array);

} // namespace vp::vectors
