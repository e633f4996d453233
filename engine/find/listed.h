#pragma once

#include "base/result.h"
#include "find/block_cut.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "surface/grid_index.h"

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace vp::find
{

/// The patches of the boundary that have a name, see grid/patches.h.
struct PatchName
{
	std::string name;

	bool operator==(const PatchName&) const = default;
};

/// A surface that takes the place of a probe's sheets. Its cells are known by their subscripts or faces, so that
/// nothing has to be searched. mesh/listed_mesh.h builds its mesh.
using ListedSurface = std::variant<surface::GridIndex, PatchName>;

std::string nameOf(const ListedSurface& surface); // "i=12.5", "patch=inlet"

/// Whether a range of grid surfaces can be shown: some block has subscripts (an input error else), and the largest
/// along that axis reaches as far (a usage error that names the range). The caller names the option.
Status checkGridIndex(const grid::BlockSet& blocks, const surface::GridIndexRange& range);

/// The cells that a grid surface shows, a list a block, as if each had been found in one step of a traversal: those of
/// the layer it lies in. Where it lies between two layers a cell of the low side (at index 0 of the one above), or,
/// where that is hidden, the one on the other side. Blocks without subscripts, or that end before the index, have none.
/// If two such surfaces lie on one seam, the first block's is shown. `filters` (per block, or empty) may reject cells.
/// The time grows with the size of the surface.
std::vector<BlockCut> gridIndexCells(const grid::BlockSet& blocks, const surface::GridIndex& at,
                                     std::span<const grid::CellFilter> filters = {});

/// An input error that lists the names there are, where no patch of the set has this one, or none of its faces could be
/// found. Faces that could not are told in a warning. The caller names the option.
Status checkPatch(const grid::BlockSet& blocks, const std::string& name);

/// The cells behind the faces of the patches of a name, a list a block, as if each had been found in one step of a
/// traversal. `filters` (per block, or empty) may turn cells down.
std::vector<BlockCut> patchCells(const grid::BlockSet& blocks, const std::string& name,
                                 std::span<const grid::CellFilter> filters = {});

/// Those of either; the surface has passed the check of its kind.
std::vector<BlockCut> listedCells(const grid::BlockSet& blocks, const ListedSurface& surface,
                                  std::span<const grid::CellFilter> filters);

} // namespace vp::find
