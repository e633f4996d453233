#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "mesh/mesh_records.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "shared/slice_types.h"

#include <optional>
#include <span>
#include <vector>

namespace vp::mesh
{

// The records of a mesh's polygons, in host memory.
std::vector<shared::PolygonRecord> recordsFromMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                                   const SheetMesh& mesh,
                                                   const std::optional<grid::FieldChoice>& field);

// The same with a value for each polygon of the mesh, NaN where there is none.
std::vector<shared::PolygonRecord> recordsFromMesh(const probe::Sheet& sheet, const SheetMesh& mesh,
                                                   std::span<const double> polygon_values);

} // namespace vp::mesh
