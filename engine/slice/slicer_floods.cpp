#include "base/timeline.h"
#include "slice/slicer.h"
#include "traverse/cell_flood.h"
#include "traverse/span_flood.h"
#include "traverse/span_rows.h"

namespace vp::slice
{

namespace
{

std::optional<seed::SheetWindow> windowOf(const probe::Sheet& sheet)
{
	return sheet.window ? std::optional<seed::SheetWindow>(sheet) : std::nullopt;
}

} // namespace

// None where the block's kind, or what it holds, is not for spans.
std::optional<traverse::SpanCut> Slicer::spansOf(const SheetSlice& sheet, std::size_t b, Finder finder)
{
	const grid::Block& block = blocks_.blocks[b];
	const surface::Plane plane = sheet.sheet.plane();
	const std::optional<seed::SheetWindow> limits = windowOf(sheet.sheet);
	const seed::SheetWindow* window = limits ? &*limits : nullptr;
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

// The cells that a device is asked about: those beside a window it would take for cut.
traverse::LaneCut asFront(std::vector<CellId> cells)
{
	traverse::LaneCut front = traverse::oneGeneration(std::move(cells));
	front.steps = front.cells.empty() ? 0 : 1;
	return front;
}

traverse::LaneCut asFront(const traverse::LaneCut& cut)
{
	std::vector<CellId> cells;
	cells.reserve(cut.cut_cells);
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kWordCut)
			cells.push_back(cut.cells[i]);
	return asFront(std::move(cells));
}

traverse::LaneCut asFront(const grid::Block& block, const traverse::SpanCut& spans)
{
	std::vector<CellId> cells;
	cells.reserve(spans.cells.cut);
	traverse::forEachCell(block, spans, [&](CellId cell) { cells.push_back(cell); });
	return asFront(std::move(cells));
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
			const std::optional<seed::SheetWindow> window = windowOf(sheet.sheet);
			// Where cells are linked the traversal enters all behind a large face that the window holds a part of.
			if (request.finder != Finder::automatic || (window && unstructured->hasLinks()))
				continue;
			found[lane] = traverse::floodCells(*unstructured, sheet.sheet.plane(), blocks_.blocks[b].bounds,
			                                   window ? &*window : nullptr, sheet.seeds.cells[b], *marks_[b]->borrow());
			if (gpu_)
				*found[lane] = asFront(*found[lane]);
		}
		else if ((sheet.spans[b] = spansOf(sheet, b, request.finder)))
		{
			found[lane].emplace();
			if (!gpu_)
				continue;
			found[lane] = asFront(blocks_.blocks[b], *sheet.spans[b]);
		}
	}
	return found;
}

} // namespace vp::slice
