#pragma once

#include "mesh/sheet_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

/// Tells which edges of a polygon are bridges to its holes: the polygon runs along them there and back
/// (cases/nested_loops.h). Lines of the mesh leave them out. Returns a mark for each corner, 1 if the edge to the next
/// corner is a bridge, or nothing if no edge is.
std::vector<std::uint8_t> bridgesOf(std::span<const std::uint32_t> polygon);

/// Returns a mark for each corner of a polygon, 1 if the side to the next corner is no line of the mesh: a bridge, or a
/// side between two parts of a polygon (SheetMesh::is_inner). Nothing if all sides are lines.
std::vector<std::uint8_t> hiddenSidesOf(const SheetMesh& mesh, std::size_t polygon);

} // namespace vp::mesh
