#include "session/sheet_stats.h"

#include "mesh/mesh_values.h"
#include "ranks/join/whole_cells.h"
#include "session/sheet_traces.h"

#include <algorithm>

namespace vp::session
{

Result<SheetStats> sheetMesh(const Session& session, const cut::Cut& slice, std::size_t sheet)
{
	SheetStats stats;
	{
		const TimedSection section(session.timeline(), "emit");
		stats.mesh = slice.mesh(session.blocks(), sheet);
		const grid::BlockSet& blocks = slice.blocksOf(session.blocks());
		stats.borders = ranks::joinBorders(session.ranks(), blocks, slice.sheets[sheet].cuts, stats.mesh);
		if (session.view().crinkle)
			stats.crinkle = slice.crinkle(session.blocks(), sheet, stats.borders.cells_elsewhere);
		if (stats.crinkle)
			stats.crinkle_borders = ranks::joinWholeCells(session.ranks(), blocks, *stats.crinkle);
	}
	if (stats.hangs())
		return stats;
	Result<SharedTraces> traces = traceSheet(session, slice, sheet, stats.mesh);
	if (!traces)
		return traces.error();
	stats.traces = std::move(*traces);
	return stats;
}

namespace
{

std::shared_ptr<const mesh::NearestParts> partsOf(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                                                  const grid::FieldChoice& field)
{
	return std::make_shared<mesh::NearestParts>(
	    mesh::nearestParts(blocks, mesh, field.inEach(blocks), field.component));
}

// Finds the polygons that pictures show, and parts them if the array names categories of points.
void addShown(const Session& session, const grid::BlockSet& blocks, const std::optional<grid::FieldChoice>& field,
              SheetStats& stats)
{
	if (!field)
		return;
	const mesh::SheetMesh* shown = stats.crinkle ? &*stats.crinkle : &stats.mesh;
	if (const std::vector<bool> left_out = blocksCoveredByOthers(blocks, *field); !left_out.empty())
	{
		stats.area_left_out = measure::measureOf(ranks::sumUp(session.ranks(), blocks, stats.mesh, {}), false).area;
		stats.shown = std::make_shared<mesh::SheetMesh>(mesh::withoutBlocks(*shown, left_out));
		shown = stats.shown.get();
		stats.area_left_out -=
		    measure::measureOf(ranks::sumUp(session.ranks(), blocks, mesh::withoutBlocks(stats.mesh, left_out), {}),
		                       false)
		        .area;
	}
	if (grid::isCategorical(blocks, field) && field->association == grid::Association::point)
		stats.parts = partsOf(blocks, *shown, *field);
}

} // namespace

measure::Overlap overlapOf(const Session& session, const cut::Cut& slice, std::size_t sheet, const SheetStats& stats)
{
	const cut::SheetCut& cut = slice.sheets[sheet];
	if (session.inputs().size() < 2 || !cut.isPlane() || !session.ranks().holdsAll())
		return {};
	return measure::overlapOf(slice.blocksOf(session.blocks()), stats.mesh, cut.sheet);
}

std::vector<bool> blocksCoveredByOthers(const grid::BlockSet& blocks, const grid::FieldChoice& field)
{
	const std::vector<const grid::Field*> fields = field.inEach(blocks);
	std::vector<bool> covered(fields.size());
	const auto volume = [](const Box& box)
	{
		const Vec3 size = glm::max(box.hi - box.lo, Vec3(0.0));
		return size.x * size.y * size.z;
	};
	// Another grid may leave room within its bounds for a part of an assembly.
	const auto isImage = [](const grid::Block& block) { return std::holds_alternative<grid::UniformGrid>(block.grid); };
	const auto covers = [&](const grid::Block& other, const grid::Block& block)
	{
		const Box common{glm::max(other.bounds.lo, block.bounds.lo), glm::min(other.bounds.hi, block.bounds.hi)};
		return other.input != block.input && isImage(other) && isImage(block) &&
		       volume(common) > 0.5 * volume(block.bounds);
	};
	for (std::size_t b = 0; b < fields.size(); ++b)
		for (std::size_t other = 0; !fields[b] && other < fields.size(); ++other)
			covered[b] = covered[b] || (fields[other] && covers(blocks.blocks[other], blocks.blocks[b]));
	return std::ranges::find(covered, true) != covered.end() ? covered : std::vector<bool>();
}

std::optional<measure::ValueAreas> valueAreas(const Session& session, const grid::BlockSet& blocks,
                                              const mesh::SheetMesh& mesh, const grid::FieldChoice& field,
                                              const mesh::NearestParts* parts)
{
	const auto& known = session.categories();
	const bool has_few = std::ranges::any_of(
	    known, [&](const CategoryArray& array)
	    { return array.name == field.name && array.association == field.association && !array.values.empty(); });
	if (!has_few || !grid::isCategorical(blocks, field))
		return std::nullopt;
	measure::ValueAreas own;
	if (field.association == grid::Association::cell)
		own = measure::valueAreas(mesh, mesh::polygonValues(blocks, mesh, field.inEach(blocks), field.component));
	else if (parts)
		own = measure::valueAreas(parts->mesh, parts->values);
	else
	{
		const auto made = partsOf(blocks, mesh, field);
		own = measure::valueAreas(made->mesh, made->values);
	}
	return ranks::sumUp(session.ranks(), std::move(own));
}

void measureSheet(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats)
{
	const TimedSection section(session.timeline(), "measure");
	const std::optional<grid::FieldChoice>& field = slice.sheets[sheet].field;
	const grid::BlockSet& blocks = slice.blocksOf(session.blocks());
	stats.measure = measure::measureOf(ranks::sumUp(session.ranks(), blocks, stats.mesh, field), field.has_value());
	stats.measure.components = ranks::componentsOf(session.ranks(), stats.borders, stats.mesh);
	if (stats.crinkle)
		stats.crinkle_area = measure::measureOf(ranks::sumUp(session.ranks(), blocks, *stats.crinkle, {}), false).area;
	stats.flux = fluxThrough(session, slice, sheet, stats.mesh);
	addShown(session, blocks, field, stats);
	stats.overlap = overlapOf(session, slice, sheet, stats);
	if (field)
		stats.value_areas =
		    valueAreas(session, blocks, stats.mesh, *field, stats.crinkle || stats.shown ? nullptr : stats.parts.get());
}

void measureForPicture(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats)
{
	if (session.colorsOverShown(slice.sheets[sheet].field))
		return measureSheet(session, slice, sheet, stats);
	const TimedSection section(session.timeline(), "measure");
	// Arrays of refined cells are new in each cut.
	measure::FiniteFields* known = slice.refined ? nullptr : session.finiteFields();
	stats.measure.nan_area = session.ranks().sum(
	    measure::nanArea(slice.blocksOf(session.blocks()), stats.mesh, slice.sheets[sheet].field, known),
	    [](double& sum, double other) { sum += other; });
	addShown(session, slice.blocksOf(session.blocks()), slice.sheets[sheet].field, stats);
}

std::vector<mesh::SheetMesh> exportedMeshes(const std::vector<SheetStats>& sheets)
{
	std::vector<mesh::SheetMesh> meshes;
	for (const SheetStats& sheet : sheets)
		meshes.push_back(sheet.crinkle ? *sheet.crinkle : sheet.mesh);
	return meshes;
}

} // namespace vp::session
