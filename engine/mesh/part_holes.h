#pragma once

#include "mesh/sheet_mesh.h"

#include <optional>

namespace vp::mesh
{

/// Parts each polygon with holes into polygons without, which cover it and nothing else and keep its cell: for files,
/// whose readers know no bridges. Vertices stay as they are. Returns nothing if no polygon has holes.
std::optional<SheetMesh> partHoles(const SheetMesh& mesh);

} // namespace vp::mesh
