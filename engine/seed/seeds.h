#pragma once

#include "base/ids.h"
#include "grid/block.h"
#include "probe/sheet.h"
#include "seed/boundary_cut.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vp::seed
{

enum class SeedMode
{
	automatic, // the hot spot and the boundary: finds every piece
	hotspot,   // only the hot spot: finds the single piece of the paper
	boundary
};

// Says what happens to a hot spot outside the grid.
enum class OutsidePolicy
{
	nearest, // it moves to the nearest point of the sheet inside the grid
	refuse,  // an error
	report   // it gives no seed, and a warning says so
};

struct SeedOptions
{
	SeedMode mode = SeedMode::automatic;
	OutsidePolicy outside = OutsidePolicy::nearest;
	// Hot spots all over the sheet besides (hot_spots.h), where a traversal goes by generations: they become few. Not
	// with SeedMode::hotspot.
	bool lattice = false;
};

// Generation 0 of a sheet, per block.
struct SheetSeeds
{
	std::vector<std::vector<CellId>> cells; // per block
	// Per block, where SeedOptions::lattice asks for them: the cut boundary faces, from which hot spots are spread.
	std::vector<std::vector<CutFace>> rim;
	// Per block: boundary faces that lie in the plane and whose cell is not cut, so that nothing else shows them. Of
	// faces that coincide at a seam one at most, and none where a cell on either side is cut.
	std::vector<std::vector<grid::BoundaryIndex::Face>> faces_in_plane;
	// The same for blocks that several processes share (grid::CellRuns), else empty: boundary faces whose cell is cut,
	// and so shows them. A face of another process may lie on each.
	std::vector<std::vector<grid::BoundaryIndex::Face>> faces_of_cut_cells;
	std::size_t count = 0;          // number of seeds in all blocks
	std::size_t hops = 0;           // number of cells that fence hops passed
	std::size_t boundary_tests = 0; // number of boxes and faces of the boundary index that were asked
	std::size_t tree_tests =
	    0; // for curved surfaces, number of boxes of the block tree and cells in them that were asked (curved_seeds.h)
	bool hot_spot_inside = false;
	// Where several processes have a part of the grid each and find a hot spot, that of the least order counts: the
	// distance to which a plane's has moved, or the number of the axis on which a curved surface has it.
	double hot_spot_order = 0.0;
	std::optional<Vec3> moved_to; // the new hot spot, if the hot spot was outside
};

// The sheet is placed in the world and has no fx (see probe::content()). Of one with a window the seeds reach every
// piece in the window: either its rim lies on the boundary there, or it is the whole window, and so holds the hot spot.
// The center of the window stands in for a hot spot outside it. needs_none: per block, whether it has straight axes and
// its cut cells are found without seeds (find/rows.h). The boundary of such a block is not searched for them.
SheetSeeds findSeeds(const grid::BlockSet& blocks, const probe::Sheet& sheet, const SeedOptions& options,
                     const std::vector<bool>& needs_none = {});

} // namespace vp::seed
