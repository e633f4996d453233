#pragma once

#include "base/ids.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <cstddef>
#include <span>

namespace vp::mesh
{

// The value of a point field at a vertex: linear along the edge, from the lower point; of a categorical one the value
// at the nearer end, in the middle the lesser of the two. component may be grid::kMagnitude: the length of the
// interpolated tuple.
double interpolate(const grid::Block& block, const grid::Field& field, int component, const EdgePoint& at);

// The same for any vertex of a mesh. fields: per block, null where a block lacks it; NaN then.
double vertexValue(const grid::BlockSet& blocks, const SheetMesh& mesh, std::size_t vertex,
                   std::span<const grid::Field* const> fields, int component);

// Returns vertexValue() of every vertex, computed on all cores.
RawVector<double> vertexValues(const grid::BlockSet& blocks, const SheetMesh& mesh,
                               std::span<const grid::Field* const> fields, int component);

double cellValue(const grid::Block& block, const grid::Field& field, int component, CellId cell);

} // namespace vp::mesh
