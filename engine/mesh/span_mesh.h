#pragma once

#include "find/span_cut.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "mesh/tidy_polygons.h"
#include "surface/plane.h"

namespace vp::mesh
{

// Adds the vertices and polygons of a structured block, turned to face along `normal`. Of a lattice edge its lower
// point is the owner, and numbers it: so a vertex is known without a search. Two passes over the spans in order, one
// for the vertices and one for the polygons, each on all cores: the mesh is the same for any number of threads.
MeshCleanup addSpans(const grid::Block& block, std::uint32_t number, const surface::Plane& plane, const Vec3& normal,
                     const find::SpanCut& cut, SheetMesh& mesh);

} // namespace vp::mesh
