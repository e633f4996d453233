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

/// What a mesh shows of one block: the cells or runs of cells that were found, and the block's boundary faces that lie
/// in the plane without their cell being cut.
struct ShownBlock
{
	std::uint32_t block;
	std::variant<const find::CellCut*, const find::SpanCut*> found; // never null
	std::span<const grid::BoundaryIndex::Face> faces_in_plane = {};
};

/// What was found of a block, which must outlive it.
ShownBlock shownBlock(std::uint32_t block, const find::BlockCut& cut,
                      std::span<const grid::BoundaryIndex::Face> faces_in_plane = {});

/// Of the whole plane: clipToWindow (clip.h) leaves the part in a window.
SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const ShownBlock> shown,
                    Hanging hanging = Hanging::keep);

/// Of a curved surface; surfaces: as each block sees it. What was found are cells.
SheetMesh buildMesh(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                    std::span<const ShownBlock> shown, Hanging hanging = Hanging::keep);

} // namespace vp::mesh
