#pragma once

#include "grid/block.h"
#include "probe/sheet.h"
#include "shared/slice_types.h"
#include "slice/field_choice.h"
#include "slice/mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace vp::slice
{

// The polygons of a mesh as they are drawn: a record is a fan of triangles about its first vertex. A polygon of more
// than six vertices becomes several records, cut along diagonals from its first vertex; a concave one is parted
// into fans that cover it and nothing else (polygon_fans.h).
std::vector<shared::PolygonRecord> recordsFromMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                                   const SheetMesh& mesh, const std::optional<FieldChoice>& field);

// The same with a value for each polygon of the mesh, NaN where there is none.
std::vector<shared::PolygonRecord> recordsFromMesh(const probe::Sheet& sheet, const SheetMesh& mesh,
                                                   std::span<const double> polygon_values);

// A value as shaders take it: NaN has a mark of its own, infinities come to less than the marks.
float drawnValue(double value);

// The cells of a cut that the CPU walked: those whose records the GPU left empty.
traverse::LaneCut walkedCells(const traverse::LaneCut& cut);

} // namespace vp::slice
