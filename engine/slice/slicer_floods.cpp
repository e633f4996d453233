#include "base/timeline.h"
#include "slice/slicer.h"
#include "traverse/cell_flood.h"
#include "traverse/span_flood.h"
#include "traverse/span_rows.h"

namespace vp::slice
{

// None where the block's kind, or what it holds, is not for spans.
std::optional<traverse::SpanCut> Slicer::spansOf(const SheetSlice& sheet, std::size_t b)
{
	const grid::Block& block = blocks_.blocks[b];
	const surface::Plane plane = sheet.sheet.plane();
	if (const auto* uniform = std::get_if<grid::UniformGrid>(&block.grid))
		return traverse::rowSpans(*uniform, plane);
	if (const auto* rectilinear = std::get_if<grid::RectilinearGrid>(&block.grid))
		return traverse::hasStraightRows(*rectilinear) ? std::optional(traverse::rowSpans(*rectilinear, plane))
		                                               : std::nullopt;
	const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&block.grid);
	if (!curvilinear || !traverse::floodTakes(*curvilinear))
		return std::nullopt;
	const Pool<traverse::SpanStore>::Loan store = stores_[b]->borrow();
	return traverse::floodSpans(*curvilinear, block.bounds, plane, sheet.seeds.cells[b], *store);
}

// Every block from seeds of its own, so that nothing has to be followed across seams. flooded: per lane; those of
// structured blocks stay empty.
void Slicer::flood(const SliceRequest& request, Slice& slice, std::span<std::optional<traverse::LaneCut>> flooded)
{
	if (request.threshold)
		return;
	const TimedSection section(request.timeline, "traverse");
	const bool one_piece = request.seeds.mode == seed::SeedMode::hotspot;
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		SheetSlice& sheet = slice.sheets[s];
		if (sheet.sheet.window)
			continue;
		sheet.spans.resize(blocks_.blocks.size());
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
		{
			if (one_piece && (blocks_.interfaces.of(b) || sheet.seeds.cells[b].empty()))
				continue;
			if (const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&blocks_.blocks[b].grid))
				flooded[s * blocks_.blocks.size() + b] =
				    traverse::floodCells(*unstructured, sheet.sheet.plane(), blocks_.blocks[b].bounds,
				                         sheet.seeds.cells[b], *marks_[b]->borrow());
			else
				sheet.spans[b] = spansOf(sheet, b);
		}
	}
}

} // namespace vp::slice
