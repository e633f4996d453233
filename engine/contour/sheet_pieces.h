#pragma once

#include "contour/clip_box.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "surface/curved.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::contour
{

// The pieces of a mesh in a box, each by the vertex that stands for it. Pieces are those of measure/components.h, and
// what meets across a large face before several small cells hangs together too, where it does not share vertices.
struct Pieces
{
	std::vector<std::uint32_t> of_vertex; // the vertex that stands for its piece
	std::vector<std::uint8_t> sides;      // per such vertex: bits of the sides of the sheet on which its piece lies
};

constexpr std::uint8_t kBothSides = 3; // the piece touches the sheet

// surfaces: the surface that the mesh is cut by, as each block sees it.
Pieces piecesOf(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces, const ClipBox& box,
                const mesh::SheetMesh& mesh);

// Drops the pieces that do not touch the sheet in the middle of the box. Returns whether there were some.
bool keepTouching(const Pieces& pieces, mesh::SheetMesh& mesh);

// Does both, and returns how many pieces are left.
std::size_t keepOnSheet(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                        const ClipBox& box, mesh::SheetMesh& mesh);

} // namespace vp::contour
