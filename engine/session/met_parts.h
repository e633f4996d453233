#pragma once

#include "read/packed_grid.h"
#include "view/view_spec.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vp::session
{

/// Returns the parts of a packed grid (read/packed_grid.h) that the only frame by these settings meets, at least one.
/// Returns nothing if the frame needs all of them: if it looks beyond the cut cells, or at neighbors, or if the
/// settings do not fit the grid.
std::optional<std::vector<std::uint64_t>> metParts(const view::ViewSpec& spec, const read::PackedGrid& grid);

} // namespace vp::session
