#pragma once

#include "find/block_cut.h"
#include "grid/block.h"
#include "mesh/hanging_vertices.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "surface/curved.h"

#include <cstdint>
#include <span>
#include <variant>

namespace vp::mesh
{

/// The part of one block that a mesh shows: the cells or runs of cells that were found, and the block's boundary faces
/// that lie in the plane and whose cells are not cut.
struct ShownBlock
{
	std::uint32_t block;
	std::variant<const find::CellCut*, const find::SpanCut*> found; // never null
	std::span<const grid::BoundaryIndex::Face> faces_in_plane = {};
};

/// Returns the part of a block that a mesh shows. The arguments must outlive it.
ShownBlock shownBlock(std::uint32_t block, const find::BlockCut& cut,
                      std::span<const grid::BoundaryIndex::Face> faces_in_plane = {});

/// Returns the mesh of the whole plane. clipToWindow (clip.h) leaves only the part in a window.
SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const ShownBlock> shown,
                    Hanging hanging = Hanging::keep);

/// Returns the mesh of a curved surface. surfaces: the surface as each block sees it. Every `found` holds cells, not
/// runs.
SheetMesh buildMesh(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                    std::span<const ShownBlock> shown, Hanging hanging = Hanging::keep);

} // namespace vp::mesh
