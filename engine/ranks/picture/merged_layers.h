#pragma once

#include "ranks/team.h"
#include "render/scene/layer_values.h"

#include <cstdint>

namespace vp::ranks
{

/// Merges layers of values along a tree of ranks. At each pixel of a layer the highest rank that has a value wins, with
/// all channels; so does the highest block, since ranks hold blocks in order. NaN is a value. Only what is not empty
/// travels. Of opaque surfaces the nearest fragment wins, at one depth that of the lower surface, then that of the
/// lower rank, as they are drawn in one process; fragments of others are kept all, since they are sorted later. Returns
/// true at the first rank, which has the layers of all then. sent: bytes of layers that this rank has sent are added to
/// it.
bool mergeLayers(Team& team, const render::LayerValues& layers, std::uint64_t& sent);

} // namespace vp::ranks
