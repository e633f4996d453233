#include "find/listed.h"

#include "base/key_numbers.h"
#include "base/messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

namespace vp::find
{

namespace
{

using surface::GridIndex;

std::optional<grid::LatticeCells> latticeReaching(const grid::Block& block, const GridIndex& at)
{
	std::optional<grid::LatticeCells> lattice = grid::latticeCellsOf(block);
	if (lattice && !(at.index >= 0.0 && at.index <= lattice->lattice().cells()[at.axis]))
		lattice.reset();
	return lattice;
}

std::array<std::uint32_t, 3> subscriptsOf(const grid::Block& block, const grid::Lattice& lattice, CellId cell)
{
	return lattice.cellIndex(
	    static_cast<CellId>(std::visit([&](const auto& grid) { return grid.sourceCell(cell); }, block.grid)));
}

class SurfaceCells
{
public:
	SurfaceCells(const grid::BlockSet& blocks, const GridIndex& at, std::span<const grid::CellFilter> filters)
	    : blocks_(blocks), at_(at), filters_(filters)
	{
		for (const grid::Block& block : blocks.blocks)
			lattices_.push_back(latticeReaching(block, at));
	}

	CellCut ofBlock(std::uint32_t block) const
	{
		if (!lattices_[block])
			return oneGeneration({});
		const std::array<std::uint32_t, 3> cells = lattices_[block]->lattice().cells();
		const surface::GridLayers layers = surface::layersOf(at_.index, cells[at_.axis]);
		// The axis whose cells are closest in memory runs fastest.
		const int fast = at_.axis == 0 ? 1 : 0;
		const int slow = at_.axis == 2 ? 1 : 2;
		std::vector<CellId> shown;
		std::array<std::uint32_t, 3> index{};
		for (index[slow] = 0; index[slow] < cells[slow]; ++index[slow])
			for (index[fast] = 0; index[fast] < cells[fast]; ++index[fast])
				add(block, cellAt(block, index, layers), shown);
		return oneGeneration(std::move(shown));
	}

private:
	CellId cellAt(std::uint32_t block, std::array<std::uint32_t, 3> index, const surface::GridLayers& layers) const
	{
		index[at_.axis] = layers.cell;
		const CellId cell = lattices_[block]->at(index);
		if (cell != kNoCell || !layers.has_other_side)
			return cell;
		++index[at_.axis];
		return lattices_[block]->at(index);
	}

	void add(std::uint32_t block, CellId cell, std::vector<CellId>& cells) const
	{
		if (cell != kNoCell && admitted(block, cell) && !isShownAcross(block, cell))
			cells.push_back(cell);
	}

	bool admitted(std::uint32_t block, CellId cell) const
	{
		return filters_.empty() || !filters_[block] || filters_[block](cell);
	}

	// Returns true if the cell shows a face on a seam, and an earlier cell shows the face across.
	bool isShownAcross(std::uint32_t block, CellId cell) const
	{
		const grid::BlockSeams* seams = blocks_.interfaces.of(block);
		if (!seams)
			return false;
		const double place = surface::placeIn(
		    subscriptsOf(blocks_.blocks[block], lattices_[block]->lattice(), cell)[at_.axis], at_.index);
		if (place != 0.0 && place != 1.0)
			return false;
		const auto face = static_cast<std::uint32_t>(2 * lattices_[block]->axisInCells(at_.axis) + (place == 1.0));
		return std::ranges::any_of(seams->of(cell, face),
		                           [&](const grid::SeamLink& link) {
			                           return link.hang == grid::Hang::none &&
			                                  std::tie(link.block, link.other) < std::tie(block, cell) && isShown(link);
		                           });
	}

	bool isShown(const grid::SeamLink& link) const
	{
		const std::optional<grid::LatticeCells>& lattice = lattices_[link.block];
		if (!lattice || static_cast<int>(link.other_face / 2) != lattice->axisInCells(at_.axis) ||
		    !admitted(link.block, link.other))
			return false;
		const std::uint32_t layer = subscriptsOf(blocks_.blocks[link.block], lattice->lattice(), link.other)[at_.axis];
		return layer + link.other_face % 2 == at_.index;
	}

	const grid::BlockSet& blocks_;
	const GridIndex& at_;
	std::span<const grid::CellFilter> filters_;
	std::vector<std::optional<grid::LatticeCells>> lattices_; // per block, where the surface meets it
};

} // namespace

Status checkGridIndex(const grid::BlockSet& blocks, const surface::GridIndexRange& range)
{
	std::uint32_t most = 0;
	for (const grid::Block& block : blocks.blocks)
		if (const auto lattice = grid::latticeCellsOf(block))
			most = std::max(most, lattice->lattice().cells()[range.axis]);
	if (most == 0)
		return Error{ErrorKind::input,
		             "the grid has no subscripts, being unstructured; cut it by a plane, with `normal`"};
	for (const double index : {range.first, range.last})
		if (!(index >= 0.0 && index <= most))
			return Error{ErrorKind::usage, fmt::format("{} runs from 0 to {} here; give an index within",
			                                           surface::axisName(range.axis), most)};
	return Nothing{};
}

std::vector<BlockCut> gridIndexCells(const grid::BlockSet& blocks, const GridIndex& at,
                                     std::span<const grid::CellFilter> filters)
{
	const SurfaceCells cells(blocks, at, filters);
	std::vector<BlockCut> cuts;
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		cuts.push_back({cells.ofBlock(b)});
	return cuts;
}

Status checkPatch(const grid::BlockSet& blocks, const std::string& name)
{
	std::vector<std::string> names;
	std::size_t faces = 0;
	std::size_t lost = 0;
	for (const grid::Patch& patch : blocks.patches)
	{
		if (std::ranges::find(names, patch.name) == names.end())
			names.push_back(patch.name);
		if (patch.name != name)
			continue;
		faces += patch.faces.size();
		lost += patch.lost;
	}
	if (lost > 0 && faces == 0)
		return Error{ErrorKind::input,
		             fmt::format("none of the {} faces of the patch {} is a boundary face of a linear "
		                         "cell; choose another patch",
		                         lost, name)};
	if (lost > 0)
		warn("{} of {} faces of the patch {} are no boundary faces of linear cells and left out", lost, lost + faces,
		     name);
	if (std::ranges::find(names, name) != names.end())
		return Nothing{};
	if (names.empty())
		return Error{ErrorKind::input,
		             "the input names no parts of its boundary; OpenFOAM patches and Exodus side sets "
		             "are read"};
	return Error{ErrorKind::input, fmt::format("there is no patch of that name; there are {}", fmt::join(names, ", "))};
}

std::vector<BlockCut> patchCells(const grid::BlockSet& blocks, const std::string& name,
                                 std::span<const grid::CellFilter> filters)
{
	std::vector<BlockCut> cuts;
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
	{
		KeyNumbers known(0);
		std::vector<CellId> cells;
		for (const grid::Patch::Face& face : grid::facesOfPatches(blocks, name, b))
			if ((filters.empty() || !filters[b] || filters[b](face.cell)) && known.find(face.cell, 0).is_new)
				cells.push_back(face.cell);
		cuts.push_back({oneGeneration(std::move(cells))});
	}
	return cuts;
}

std::string nameOf(const ListedSurface& surface)
{
	if (const auto* patch = std::get_if<PatchName>(&surface))
		return "patch=" + patch->name;
	return surface::nameOf(std::get<surface::GridIndex>(surface));
}

std::vector<BlockCut> listedCells(const grid::BlockSet& blocks, const ListedSurface& surface,
                                  std::span<const grid::CellFilter> filters)
{
	if (const auto* patch = std::get_if<PatchName>(&surface))
		return patchCells(blocks, patch->name, filters);
	return gridIndexCells(blocks, std::get<surface::GridIndex>(surface), filters);
}

} // namespace vp::find
