#include "session/sheet_stats.h"

#include "ranks/data/share.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/join/whole_cells.h"
#include "ranks/team.h"
#include "session/sheet_traces.h"

namespace vp::session
{

Result<SheetStats> sheetMesh(const Session& session, const cut::Cut& slice, std::size_t sheet)
{
	SheetStats stats;
	{
		const TimedSection section(session.timeline.get(), "emit");
		stats.mesh = slice.mesh(session.blocks, sheet);
		if (session.team)
			stats.borders = ranks::joinBorders(*session.team, slice.blocksOf(session.blocks), session.share->whole,
			                                   slice.sheets[sheet].cuts, stats.mesh);
		if (session.view.crinkle)
			stats.crinkle = slice.crinkle(session.blocks, sheet, stats.borders.cells_elsewhere);
		if (session.team && stats.crinkle)
			stats.crinkle_borders = ranks::joinWholeCells(*session.team, slice.blocksOf(session.blocks),
			                                              session.share->whole, *stats.crinkle);
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
	const TimedSection section(session.timeline.get(), "measure");
	const std::optional<grid::FieldChoice>& field = slice.sheets[sheet].field;
	if (session.team)
	{
		measure::SheetSums sums = measure::sumUp(slice.blocksOf(session.blocks), stats.mesh, field);
		ranks::sumOverAll(*session.team, sums, [](auto& sum, const auto& other) { sum.add(other); });
		stats.measure = measure::measureOf(sums, field.has_value());
		stats.measure.components = stats.borders.components;
	}
	else
		stats.measure = measure::measure(slice.blocksOf(session.blocks), stats.mesh, field);
	if (stats.crinkle)
	{
		measure::SheetSums sums = measure::sumUp(slice.blocksOf(session.blocks), *stats.crinkle, {});
		if (session.team)
			ranks::sumOverAll(*session.team, sums, [](auto& sum, const auto& other) { sum.add(other); });
		stats.crinkle_area = measure::measureOf(sums, false).area;
	}
	stats.flux = fluxThrough(session, slice, sheet, stats.mesh);
}

void measureForPicture(const Session& session, const cut::Cut& slice, std::size_t sheet, SheetStats& stats)
{
	if (session.spec.look.range_of == view::RangeOf::slice)
		return measureSheet(session, slice, sheet, stats);
	const TimedSection section(session.timeline.get(), "measure");
	// Arrays of refined cells are new in each cut.
	measure::FiniteFields* known = slice.refined ? nullptr : session.finite_fields.get();
	stats.measure.nan_area =
	    measure::nanArea(slice.blocksOf(session.blocks), stats.mesh, slice.sheets[sheet].field, known);
	if (session.team)
		ranks::sumOverAll(*session.team, stats.measure.nan_area, [](double& sum, double other) { sum += other; });
}

Result<std::vector<SheetStats>> sheetStats(const Session& session, const cut::Cut& slice)
{
	std::vector<SheetStats> sheets;
	for (std::size_t s = 0; s < slice.sheets.size(); ++s)
	{
		Result<SheetStats> stats = sheetMesh(session, slice, s);
		if (!stats)
			return stats.error();
		sheets.push_back(std::move(*stats));
		measureSheet(session, slice, s, sheets.back());
	}
	return sheets;
}

std::vector<mesh::SheetMesh> exportedMeshes(const std::vector<SheetStats>& sheets)
{
	std::vector<mesh::SheetMesh> meshes;
	for (const SheetStats& sheet : sheets)
		meshes.push_back(sheet.crinkle ? *sheet.crinkle : sheet.mesh);
	return meshes;
}

} // namespace vp::session
