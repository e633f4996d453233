#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

/// Tells which edges of a polygon are bridges to its holes: the polygon runs along them there and back
/// (cases/nested_loops.h). Lines of the mesh leave them out. Returns a mark for each corner, 1 if the edge to the next
/// corner is a bridge, or nothing if no edge is.
std::vector<std::uint8_t> bridgesOf(std::span<const std::uint32_t> polygon);

} // namespace vp::mesh
