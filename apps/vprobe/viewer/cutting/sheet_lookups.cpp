#include "viewer/cutting/sheet_lookups.h"

#include "picture/sheet_values.h"

#include <limits>

namespace vp::app
{

namespace
{

bool isCategorical(const session::Session& session, const std::optional<grid::FieldChoice>& field)
{
	if (field)
		for (const grid::Field* of_block : field->inEach(session.blocks()))
			if (of_block && of_block->categorical)
				return true;
	return false;
}

std::vector<std::uint64_t> sourceCells(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh)
{
	std::vector<std::uint64_t> cells;
	cells.reserve(mesh.polygons());
	for (const mesh::BlockCell& cell : mesh.polygon_cells)
		cells.push_back(std::visit([&](const auto& grid) { return std::uint64_t(grid.sourceCell(cell.cell)); },
		                           blocks.blocks[cell.block].grid));
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
		const mesh::SheetMesh& mesh = cut_->sheets[s].mesh;
		std::optional<OfSheet>& made = sheets_.emplace_back();
		if (!sheet.isPlane() || cut_->sheets[s].crinkle)
			continue;
		render::SheetValues values = picture::sheetValues(session.blocks(), sheet, mesh, by_generation);
		made.emplace(OfSheet{.lookup = {mesh, sheet.sheet},
		                     .array = {},
		                     .nearest = !by_generation && isCategorical(session, sheet.field),
		                     .of_vertices = std::move(values.of_vertices),
		                     .of_polygons = std::move(values.of_polygons),
		                     .cells = sourceCells(session.blocks(), mesh)});
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
		found.value = of.nearest ? of.of_vertices[place->nearestVertex()] : of.lookup.value(*place, of.of_vertices);
	if (blocks_.size() > 1)
		found.block =
		    blocks_[place->cell.block].empty() ? std::to_string(place->cell.block) : blocks_[place->cell.block];
	return found;
}

} // namespace vp::app
