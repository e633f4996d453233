#pragma once

#include "mesh/mesh_records.h"
#include "ranks/ranks.h"
#include "render/renderer.h"
#include "render/scene/layer_values.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace vp::ranks
{

/// Merges layers of values along a tree of ranks. At each pixel of a layer the highest rank that has a value wins, with
/// all channels; so does the highest block, since ranks hold blocks in order. NaN is a value. Only what is not empty
/// travels. Of opaque surfaces the nearest fragment wins, at one depth that of the lower surface, then that of the
/// lower rank, as they are drawn in one process; fragments of others are kept all, since they are sorted later. Returns
/// true at the first rank, which has the layers of all then. sent: bytes of layers that this rank has sent are added to
/// it.
bool mergeLayers(Team& team, const render::LayerValues& layers, std::uint64_t& sent);

/// Draws a scene of which each rank has a part. Only the first rank gets the picture, the others an empty one. goes_on:
/// see render::Renderer::draw(); several ranks do not ask it.
Result<render::Picture> draw(const Ranks& ranks, render::Renderer& renderer, const render::Scene& scene,
                             Timeline* timeline, const std::function<bool()>& goes_on);

/// Returns the bounds of the polygons of a sheet, if other ranks draw a part of them. own: of the polygons here.
std::optional<mesh::UvBounds> boundsOfAll(const Ranks& ranks, const std::optional<mesh::UvBounds>& own);

} // namespace vp::ranks
