#pragma once

#include "base/ids.h"
#include "find/generations.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "seed/sheet_window.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::find
{

/// A face of a cell, all of whose points lie in the surface, and that no other cell of its block has.
struct FlatFace
{
	grid::BoundaryIndex::Face face;
	bool shown; // its cell is cut, and has the face as its polygon
};

/// The result of a scan of one block for one sheet.
struct Scan
{
	CellCut cut;
	std::vector<FlatFace> flat; // ascending by cell, then face
};

/// Returns the numbers of the runs of a block that a surface may meet in a window, ascending: by their boxes, or by
/// their values. The block must have runs. window: null if there is none.
template <class Surface>
std::vector<std::uint32_t> runsMet(const grid::Block& block, const Surface& surface, const seed::SheetWindow* window);

/// Looks at every cell of an unstructured grid once, in the order of the cells, on all cores: first at the side on
/// which each point lies, then at the cells whose points lie on both. No neighbors, seeds or marks are needed. Cells
/// and codes are those of breadthFirst(), without generations; cells that the filter rejects or that lie beside the
/// window are left out of the list. The same result for any number of threads. Memory: a byte a point.
///
/// If the block has runs, it looks at those of runsMet() alone. They must have been fetched.
///
/// Throws grid::WrongPoint if the ids of the cells have not been checked, and one names no point.
///
/// window, filter: null and empty where there is none. Surface: surface::Plane or surface::BlockSurface.
template <class Surface>
Scan scanCells(const grid::Block& block, const Surface& surface, const seed::SheetWindow* window,
               const grid::CellFilter& filter);

/// The flat faces of each block that nothing else shows: seed::SheetSeeds::faces_in_plane. Of faces that lie on each
/// other, in two blocks or in one whose points are not merged, one at most is taken, and none where one is shown.
std::vector<std::vector<grid::BoundaryIndex::Face>> facesToShow(const grid::BlockSet& blocks,
                                                                std::span<const Scan> scans);

} // namespace vp::find
