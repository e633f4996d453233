#pragma once

#include "find/generations.h"
#include "find/span_cut.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "surface/curved.h"

#include <cstdint>
#include <span>

namespace vp::mesh
{

// What was found of a sheet in one block, as cells or as spans of cells (the other is null), and the block's boundary
// faces that lie in the plane without their cell being cut.
struct BlockCut
{
	std::uint32_t block;
	const find::CellCut* cut;
	const find::SpanCut* spans;
	std::span<const grid::BoundaryIndex::Face> faces_in_plane;
};

// Of the whole plane: clipToWindow (clip.h) leaves the part in a window.
SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const BlockCut> cuts);

// Of a curved surface; surfaces: as each block sees it. The cuts hold cells.
SheetMesh buildMesh(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                    std::span<const BlockCut> cuts);

} // namespace vp::mesh
