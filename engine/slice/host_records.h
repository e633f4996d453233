#pragma once

#include "grid/block.h"
#include "probe/sheet.h"
#include "shared/slice_types.h"
#include "slice/field_choice.h"
#include "slice/mesh.h"
#include "slice/mesh_records.h"

#include <optional>
#include <span>
#include <vector>

namespace vp::slice
{

// The records of a mesh's polygons, in host memory.
std::vector<shared::PolygonRecord> recordsFromMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                                   const SheetMesh& mesh, const std::optional<FieldChoice>& field);

// The same with a value for each polygon of the mesh, NaN where there is none.
std::vector<shared::PolygonRecord> recordsFromMesh(const probe::Sheet& sheet, const SheetMesh& mesh,
                                                   std::span<const double> polygon_values);

// The cells of a cut that the CPU walked: those whose records the GPU left empty.
traverse::LaneCut walkedCells(const traverse::LaneCut& cut);

} // namespace vp::slice
