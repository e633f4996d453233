#include "session/sheet_stats.h"

#include "ranks/join/hanging_borders.h"
#include "ranks/join/whole_cells.h"
#include "session/sheet_traces.h"

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
	if (stats.borders.hangs || stats.crinkle_borders.hangs)
		return ranks::sizesDiffer();
	Result<SharedTraces> traces = traceSheet(session, slice, sheet, stats.mesh);
	if (!traces)
		return traces.error();
	stats.traces = std::move(*traces);
	return stats;
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
}

void measureForPicture(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats)
{
	if (session.spec().look.range_of == view::RangeOf::slice)
		return measureSheet(session, slice, sheet, stats);
	const TimedSection section(session.timeline(), "measure");
	// Arrays of refined cells are new in each cut.
	measure::FiniteFields* known = slice.refined ? nullptr : session.finiteFields();
	stats.measure.nan_area = session.ranks().sum(
	    measure::nanArea(slice.blocksOf(session.blocks()), stats.mesh, slice.sheets[sheet].field, known),
	    [](double& sum, double other) { sum += other; });
}

std::vector<mesh::SheetMesh> exportedMeshes(const std::vector<SheetStats>& sheets)
{
	std::vector<mesh::SheetMesh> meshes;
	for (const SheetStats& sheet : sheets)
		meshes.push_back(sheet.crinkle ? *sheet.crinkle : sheet.mesh);
	return meshes;
}

} // namespace vp::session
