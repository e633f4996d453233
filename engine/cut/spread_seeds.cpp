#include "cut/spread_seeds.h"

#include "seed/cut_cells.h"
#include "seed/hot_spots.h"

#include <algorithm>

namespace vp::cut
{

namespace
{

// Returns true if nearly all cells of a sheet's earlier cut are still cut at its new place, judged by a sample.
bool staysIn(const grid::Block& block, const probe::Sheet& sheet, std::span<const CellId> cells)
{
	constexpr std::size_t kSample = 128;
	constexpr double kNearly = 0.9;
	const surface::Plane plane = sheet.plane();
	const std::optional<seed::SheetWindow> window =
	    sheet.window ? std::optional<seed::SheetWindow>(sheet) : std::nullopt;
	const std::size_t step = std::max<std::size_t>(1, cells.size() / kSample);
	std::size_t asked = 0;
	std::size_t cut = 0;
	grid::CellFaces faces;
	const auto ask = [&](const auto& grid)
	{
		for (std::size_t i = step / 2; i < cells.size(); i += step, ++asked)
		{
			if (!seed::isCut(grid, plane, cells[i]))
				continue;
			if (window)
				grid.cellFaces(cells[i], faces);
			cut += !window || window->meetsCell(grid, plane, faces);
		}
	};
	std::visit(ask, block.grid);
	return static_cast<double>(cut) > kNearly * static_cast<double>(asked);
}

void add(const std::vector<CellId>& cells, std::size_t block, seed::SheetSeeds& seeds)
{
	seeds.cells[block].insert(seeds.cells[block].end(), cells.begin(), cells.end());
	seeds.count += cells.size();
}

} // namespace

void spreadSeeds(const grid::Block& block, std::size_t number, const SheetCut* was, SheetCut& sheet)
{
	std::vector<CellId> kept;
	if (was && number < was->cuts.size() && was->sheet.window == sheet.sheet.window)
		find::forEachCutCell(block, was->cuts[number], [&](CellId cell) { kept.push_back(cell); });
	if (staysIn(block, sheet.sheet, kept))
		return add(kept, number, sheet.seeds);
	const seed::HotSpots spots =
	    seed::spreadHotSpots(block, sheet.sheet, sheet.seeds.rim[number], sheet.seeds.cells[number]);
	add(spots.cells, number, sheet.seeds);
	// In the order of memory, for their points.
	std::ranges::sort(sheet.seeds.cells[number]);
	sheet.seeds.hops += spots.hops;
}

} // namespace vp::cut
