#include "base/timeline.h"
#include "cut/cutter.h"
#include "seed/cut_cells.h"
#include "seed/hot_spots.h"

#include <algorithm>

namespace vp::cut
{

namespace
{

std::vector<CellId> cutCellsOf(const find::CellCut& cut)
{
	std::vector<CellId> cells;
	cells.reserve(cut.cut_cells);
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kCodeCut)
			cells.push_back(cut.cells[i]);
	return cells;
}

// Whether nearly all of the cells that a sheet cut before are cut where it stands now, as a sample has it.
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

// More of generation 0 where a lattice of hot spots is asked for and a traversal is to come: the cells of the cut
// before where the sheet has hardly moved, else those along the lattice. Not with a threshold: cells that it turns down
// may enclose others, which are not to be found.
void Cutter::spreadSeeds(const CutRequest& request, const Before& before, const Found& found, Cut& slice) const
{
	if (!request.seeds.lattice || request.threshold || request.seeds.mode == seed::SeedMode::hotspot)
		return;
	const TimedSection section(request.timeline, "seed");
	for (std::size_t lane = 0; lane < found.size(); ++lane)
	{
		const std::size_t s = lane / blocks_.blocks.size();
		const std::size_t b = lane % blocks_.blocks.size();
		const grid::Block& block = blocks_.blocks[b];
		SheetCut& sheet = slice.sheets[s];
		if (!found[lane])
		{
			const SheetCut* last = before.empty() ? nullptr : before[s];
			const bool same_window = last && b < last->cuts.size() && last->sheet.window == sheet.sheet.window;
			const std::vector<CellId> kept = same_window ? cutCellsOf(last->cuts[b]) : std::vector<CellId>();
			if (staysIn(block, sheet.sheet, kept))
				add(kept, b, sheet.seeds);
			else
			{
				const seed::HotSpots spots =
				    seed::spreadHotSpots(block, sheet.sheet, sheet.seeds.rim[b], sheet.seeds.cells[b]);
				add(spots.cells, b, sheet.seeds);
				// As they lie in memory, for their points.
				std::ranges::sort(sheet.seeds.cells[b]);
				sheet.seeds.hops += spots.hops;
			}
		}
		sheet.seeds.rim[b] = {};
	}
}

} // namespace vp::cut
