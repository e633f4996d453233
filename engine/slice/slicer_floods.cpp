#include "base/timeline.h"
#include "slice/slicer.h"
#include "traverse/cell_flood.h"
#include "traverse/span_flood.h"
#include "traverse/span_rows.h"

namespace vp::slice
{

// None where the block's kind, or what it holds, is not for spans.
std::optional<traverse::SpanCut> Slicer::spansOf(const SheetSlice& sheet, std::size_t b, Finder finder)
{
	const grid::Block& block = blocks_.blocks[b];
	const surface::Plane plane = sheet.sheet.plane();
	std::optional<seed::SheetWindow> its_window;
	if (sheet.sheet.window)
		its_window.emplace(sheet.sheet);
	const seed::SheetWindow* window = its_window ? &*its_window : nullptr;
	if (const auto* uniform = std::get_if<grid::UniformGrid>(&block.grid))
		return traverse::rowSpans(*uniform, plane, window);
	if (const auto* rectilinear = std::get_if<grid::RectilinearGrid>(&block.grid))
		return traverse::hasStraightRows(*rectilinear) ? std::optional(traverse::rowSpans(*rectilinear, plane, window))
		                                               : std::nullopt;
	const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&block.grid);
	if (finder != Finder::automatic || !curvilinear || !traverse::floodTakes(*curvilinear))
		return std::nullopt;
	const Pool<traverse::SpanStore>::Loan store = stores_[b]->borrow();
	return traverse::floodSpans(*curvilinear, block.bounds, plane, window, sheet.seeds.cells[b], *store);
}

namespace
{

void countAsGeneration(traverse::LaneCut& cut)
{
	cut.generation_starts = {0, static_cast<std::uint32_t>(cut.cells.size())};
	cut.steps = 1;
}

traverse::LaneCut cellsOf(const grid::Block& block, const traverse::SpanCut& spans)
{
	std::vector<CellId> cells;
	cells.reserve(spans.cells.cut);
	traverse::forEachCell(block, spans, [&](CellId cell) { cells.push_back(cell); });
	return traverse::oneGeneration(std::move(cells));
}

} // namespace

// Every block from seeds of its own, so that nothing has to be followed across seams.
Slicer::Found Slicer::find(const SliceRequest& request, Slice& slice)
{
	Found found(slice.sheets.size() * blocks_.blocks.size());
	if (request.threshold || request.finder == Finder::traversal)
		return found;
	const TimedSection section(request.timeline, "traverse");
	const bool one_piece = request.seeds.mode == seed::SeedMode::hotspot;
	for (std::size_t lane = 0; lane < found.size(); ++lane)
	{
		SheetSlice& sheet = slice.sheets[lane / blocks_.blocks.size()];
		const std::size_t b = lane % blocks_.blocks.size();
		sheet.spans.resize(blocks_.blocks.size());
		if (one_piece && (blocks_.interfaces.of(b) || sheet.seeds.cells[b].empty() || sheet.sheet.window))
			continue;
		if (const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&blocks_.blocks[b].grid))
		{
			if (request.finder != Finder::automatic || sheet.sheet.window)
				continue;
			found[lane] = traverse::floodCells(*unstructured, sheet.sheet.plane(), blocks_.blocks[b].bounds,
			                                   sheet.seeds.cells[b], *marks_[b]->borrow());
			if (gpu_)
				countAsGeneration(*found[lane]);
		}
		else if ((sheet.spans[b] = spansOf(sheet, b, request.finder)))
		{
			found[lane].emplace();
			if (!gpu_)
				continue;
			found[lane] = cellsOf(blocks_.blocks[b], *sheet.spans[b]);
			countAsGeneration(*found[lane]);
		}
	}
	return found;
}

} // namespace vp::slice
