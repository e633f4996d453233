#include "viewer/cutting/sheet_lookups.h"

#include "picture/sheet_values.h"

#include <algorithm>
#include <limits>

namespace vp::app
{

namespace
{

std::vector<std::uint64_t> sourceCells(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh)
{
	std::vector<std::uint64_t> cells;
	cells.reserve(mesh.polygons());
	for (const mesh::BlockCell& cell : mesh.polygon_cells)
		cells.push_back(static_cast<std::uint64_t>(grid::cellNumber(blocks.blocks[cell.block], cell.cell)));
	return cells;
}

} // namespace

SheetLookups::SheetLookups(const session::Session& session, std::shared_ptr<const session::Frame> cut,
                           bool by_generation)
    : cut_(std::move(cut))
{
	for (const grid::Block& block : session.blocks().blocks)
		blocks_.push_back(block.name);
	for (std::size_t s = 0; s < cut_->sheets.size(); ++s)
	{
		const cut::SheetCut& sheet = cut_->slice.sheets[s];
		std::optional<OfSheet>& made = sheets_.emplace_back();
		if (!sheet.isPlane() || cut_->sheets[s].crinkle)
			continue;
		picture::ShownPolygons shown = picture::shownPolygons(session.blocks(), sheet, cut_->sheets[s], by_generation);
		made.emplace(OfSheet{.lookup = {shown.mesh, sheet.sheet},
		                     .array = {},
		                     .is_scenes = by_generation || sheet.field == session.view().field,
		                     .of_vertices = std::move(shown.values.of_vertices),
		                     .of_polygons = std::move(shown.values.of_polygons),
		                     .cells = sourceCells(session.blocks(), shown.mesh)});
		made->array = by_generation ? "generation" : sheet.field ? sheet.field->title(session.blocks()) : "";
	}
}

std::optional<SheetLookups::Found> SheetLookups::at(std::size_t sheet, const glm::dvec2& content_uv) const
{
	if (sheet >= sheets_.size() || !sheets_[sheet])
		return std::nullopt;
	const OfSheet& of = *sheets_[sheet];
	const std::optional<measure::SheetPlace> place = of.lookup.at(content_uv);
	if (!place)
		return std::nullopt;
	Found found{of.array, std::numeric_limits<double>::quiet_NaN(), {}, of.cells[place->polygon]};
	if (!of.of_polygons.empty())
		found.value = of.of_polygons[place->polygon];
	else if (!of.of_vertices.empty())
		found.value = of.lookup.value(*place, of.of_vertices);
	if (blocks_.size() > 1)
		found.block =
		    blocks_[place->cell.block].empty() ? std::to_string(place->cell.block) : blocks_[place->cell.block];
	return found;
}

void SheetLookups::count(const std::function<double(double value)>& place, std::span<std::size_t> bins) const
{
	for (const std::optional<OfSheet>& of : sheets_)
	{
		if (!of || !of->is_scenes)
			continue;
		for (const double value : of->of_polygons.empty() ? of->of_vertices : of->of_polygons)
			if (const double at = place(value); at >= 0.0 && at <= 1.0)
				++bins[std::min(static_cast<std::size_t>(at * static_cast<double>(bins.size())), bins.size() - 1)];
	}
}

} // namespace vp::app
