#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "view/context_spec.h"

namespace vp::picture
{

/// Returns the polygons of a surface around the sheets, in world coordinates. If the blocks do not have this surface,
/// the error names it and the remedy.
Result<mesh::SheetMesh> contextMesh(const grid::BlockSet& blocks, const view::ContextSpec& context);

} // namespace vp::picture
