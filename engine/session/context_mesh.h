#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "view/context_spec.h"

namespace vp::session
{

/// The polygons of what is drawn around the sheets, in world coordinates. An error names the context and the remedy
/// where the blocks do not have it.
Result<mesh::SheetMesh> contextMesh(const grid::BlockSet& blocks, const view::ContextSpec& context);

} // namespace vp::session
