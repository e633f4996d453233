#include "base/timeline.h"
#include "cut/cutter.h"
#include "find/cells.h"
#include "find/rows.h"
#include "find/spans.h"

namespace vp::cut
{

namespace
{

std::optional<seed::SheetWindow> windowOf(const probe::Sheet& sheet)
{
	return sheet.window ? std::optional<seed::SheetWindow>(sheet) : std::nullopt;
}

} // namespace

// The plan has one of two strategies for the block: rows or spans.
find::SpanCut Cutter::spansOf(const SheetCut& sheet, std::size_t b)
{
	const grid::Block& block = blocks_.blocks[b];
	const surface::Plane plane = sheet.sheet.plane();
	const std::optional<seed::SheetWindow> limits = windowOf(sheet.sheet);
	const seed::SheetWindow* window = limits ? &*limits : nullptr;
	if (const auto* uniform = std::get_if<grid::UniformGrid>(&block.grid))
		return find::rowSpans(*uniform, plane, window);
	if (const auto* rectilinear = std::get_if<grid::RectilinearGrid>(&block.grid))
		return find::rowSpans(*rectilinear, plane, window);
	const Pool<find::SpanStore>::Loan store = stores_[b]->borrow();
	return find::floodSpans(std::get<grid::CurvilinearGrid>(block.grid), block.bounds, plane, window,
	                        sheet.seeds.cells[b], *store);
}

find::CellCut Cutter::floodCells(const SheetCut& sheet, std::size_t b)
{
	const grid::Block& block = blocks_.blocks[b];
	const std::optional<seed::SheetWindow> window = windowOf(sheet.sheet);
	return find::floodCells(std::get<grid::UnstructuredGrid>(block.grid), sheet.sheet.plane(), block.bounds,
	                        window ? &*window : nullptr, sheet.seeds.cells[b], *marks_[b]->borrow());
}

namespace
{

// The cells that a device is asked about: those beside a window it would take for cut.
find::CellCut asFront(std::vector<CellId> cells)
{
	find::CellCut front = find::oneGeneration(std::move(cells));
	front.steps = front.cells.empty() ? 0 : 1;
	return front;
}

find::CellCut asFront(const find::CellCut& cut)
{
	std::vector<CellId> cells;
	cells.reserve(cut.cut_cells);
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kCodeCut)
			cells.push_back(cut.cells[i]);
	return asFront(std::move(cells));
}

find::CellCut asFront(const grid::Block& block, const find::SpanCut& spans)
{
	std::vector<CellId> cells;
	cells.reserve(spans.cells.cut);
	find::forEachCell(block, spans, [&](CellId cell) { cells.push_back(cell); });
	return asFront(std::move(cells));
}

} // namespace

// What needs no generations, every block from seeds of its own, so that nothing has to be followed across seams.
Cutter::Found Cutter::find(const CutRequest& request, const find::CutPlan& plan, Cut& slice)
{
	Found found(slice.sheets.size() * blocks_.blocks.size());
	std::optional<TimedSection> section;
	for (std::size_t lane = 0; lane < found.size(); ++lane)
	{
		const std::size_t b = lane % blocks_.blocks.size();
		const find::Strategy strategy = plan.sheets[lane / blocks_.blocks.size()][b].strategy;
		if (strategy == find::Strategy::generations)
			continue;
		SheetCut& sheet = slice.sheets[lane / blocks_.blocks.size()];
		sheet.spans.resize(blocks_.blocks.size());
		// The piece at the hot spot lies in another block: nothing of this one is found, in no generations.
		if (request.seeds.mode == seed::SeedMode::hotspot && sheet.seeds.cells[b].empty())
			continue;
		if (!section)
			section.emplace(request.timeline, "traverse");
		if (strategy == find::Strategy::cells)
		{
			found[lane] = floodCells(sheet, b);
			if (gpu_)
				found[lane] = asFront(*found[lane]);
			continue;
		}
		sheet.spans[b] = spansOf(sheet, b);
		found[lane] = gpu_ ? asFront(blocks_.blocks[b], *sheet.spans[b]) : find::CellCut();
	}
	return found;
}

} // namespace vp::cut
