#include "report/stats_json.h"

#include "gpu/driver_name.h"
#include "ranks/data/share.h"
#include "ranks/write/joined_stats.h"
#include "read/sandbox.h"
#include "report/duration.h"
#include "report/explain.h"
#include "session/categories.h"
#include "vectors/traces.h"
#include "version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_set>

namespace vp::app
{

namespace
{

nlohmann::json orNull(const std::optional<double>& value)
{
	return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json asJson(const Vec3& v)
{
	return {v.x, v.y, v.z};
}

// In the sheet's x and y, from its origin.
nlohmann::json asJson(const std::optional<probe::Window>& window)
{
	if (!window)
		return {};
	return {window->x0, window->x1, window->y0, window->y1};
}

// Traversal figures of a sheet, over its blocks.
struct TraversalSums
{
	std::size_t cut_cells = 0;        // of the file
	std::size_t linear_cut_cells = 0; // of the grids: the same but where curved cells were cut into linear ones
	std::size_t touched = 0;
	std::size_t scanned = 0; // where no cell was searched for
	std::size_t walked = 0;
	std::size_t generations = 0; // 0 where all were found at once, without a device
	std::size_t front_max = 0;
	std::size_t boundary_faces = 0;
};

// The file's cells among those a lane cuts.
std::size_t sourceCutCells(const grid::Block& block, const find::CellCut& cut)
{
	const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid);
	if (!grid || !grid->splitsCells())
		return cut.cut_cells;
	std::unordered_set<std::size_t> sources;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.codes[i] & shared::kCodeCut)
			sources.insert(grid->sourceCell(cut.cells[i]));
	return sources.size();
}

void addCells(const grid::Block& block, const find::CellCut& cut, TraversalSums& sums)
{
	sums.cut_cells += sourceCutCells(block, cut);
	sums.linear_cut_cells += cut.cut_cells;
	for (const std::uint32_t code : cut.codes)
		sums.walked += (code & shared::kCodeWalk) != 0;
}

void addCells(const grid::Block&, const find::SpanCut& cut, TraversalSums& sums)
{
	sums.cut_cells += cut.cells.cut;
	sums.linear_cut_cells += cut.cells.cut;
	sums.walked += cut.cells.walked;
}

TraversalSums sumUp(const grid::BlockSet& blocks, const cut::SheetCut& sheet)
{
	TraversalSums sums;
	for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
	{
		const find::BlockCut& cut = sheet.cuts[b];
		std::visit([&](const auto& found) { addCells(blocks.blocks[b], found, sums); }, cut.found);
		sums.touched += cut.touchedCells();
		sums.scanned += cut.scannedCells();
		sums.generations = std::max(sums.generations, cut.steps());
		sums.front_max = std::max(sums.front_max, cut.frontMax());
	}
	for (const auto& faces : sheet.seeds.faces_in_plane)
		sums.boundary_faces += faces.size();
	return sums;
}

// A surface of another kind has no frame: null.
nlohmann::json frameJson(const cut::SheetCut& sheet)
{
	if (sheet.surface)
		return {{"surface", find::nameOf(*sheet.surface)},
		        {"origin", nullptr},
		        {"normal", nullptr},
		        {"up", nullptr},
		        {"window", nullptr}};
	return {{"surface", sheet.sheet.form ? nlohmann::json(sheet.sheet.form->text()) : nlohmann::json()},
	        {"origin", asJson(sheet.sheet.origin)},
	        {"normal", asJson(sheet.sheet.normal)},
	        {"up", asJson(sheet.sheet.up)},
	        {"window", asJson(sheet.sheet.window)}};
}

nlohmann::json crinkleJson(const session::SheetStats& stats)
{
	if (!stats.crinkle)
		return {};
	return {{"faces", stats.crinkle->polygons()},
	        {"vertices", stats.crinkle->positions.size() - stats.crinkle_borders.vertices_elsewhere},
	        {"area", stats.crinkle_area}};
}

nlohmann::json tracesJson(const session::Session& session, const vectors::Traces& traces)
{
	std::array<std::size_t, vectors::kTraceEndWords.size()> counts{};
	const auto count = [&](const std::vector<vectors::TraceEnd>& of_traces)
	{
		for (const vectors::TraceEnd end : of_traces)
			++counts[static_cast<std::size_t>(end)];
	};
	if (session.view().launch->direction != vectors::Direction::forward)
		count(traces.begins);
	if (session.view().launch->direction != vectors::Direction::backward)
		count(traces.ends);
	nlohmann::json ends = nlohmann::json::object();
	for (std::size_t i = 0; i < counts.size(); ++i)
		ends[vectors::kTraceEndWords[i]] = counts[i];
	return {{"array", session.view().vector_array->name},
	        {"traces", traces.count()},
	        {"points", traces.points.size()},
	        {"dt", session.launch().dt},
	        {"ends", ends}};
}

// Adds the area of each value, and the names of those values that the file has names for.
void addLabels(const session::Session& session, const grid::FieldChoice& field, const measure::ValueAreas& areas,
               nlohmann::json& json)
{
	nlohmann::json& labels = json["labels"] = nlohmann::json::object();
	for (const auto& [value, area] : areas)
		labels[fmt::format("{}", value)] = area.value();
	for (const auto& [value, name] : session::labelNames(session.blocks(), field))
		if (areas.contains(value))
			json["label_names"][fmt::format("{}", value)] = name;
}

nlohmann::json sheetJson(const session::Session& session, const cut::Cut& slice, std::size_t number,
                         const session::SheetStats& stats)
{
	const cut::SheetCut& sheet = slice.sheets[number];
	const TraversalSums sums = sumUp(slice.blocksOf(session.blocks()), sheet);
	nlohmann::json json = frameJson(sheet);
	json.update({{"array", sheet.field ? nlohmann::json(sheet.field->title(session.blocks())) : nlohmann::json()},
	             {"cut_cells", sums.cut_cells},
	             {"linear_cut_cells", sums.linear_cut_cells},
	             {"polygons", stats.mesh.polygons()},
	             {"vertices", stats.mesh.positions.size() - stats.borders.vertices_elsewhere},
	             {"components", stats.measure.components},
	             {"area", stats.measure.area},
	             {"mean", orNull(stats.measure.mean)},
	             {"min", orNull(stats.measure.min)},
	             {"max", orNull(stats.measure.max)},
	             {"seeds", sheet.seeds.count},
	             {"hops", sheet.seeds.hops},
	             {"boundary_tests", sheet.seeds.boundary_tests},
	             {"tree_tests", sheet.seeds.tree_tests},
	             {"hot_spot_inside", sheet.seeds.hot_spot_inside},
	             {"generations", sums.generations},
	             {"front_max", sums.front_max},
	             {"cells_touched", sums.touched},
	             {"cells_scanned", sums.scanned},
	             {"cells_walked", sums.walked},
	             {"cells_twisted", stats.mesh.cells_twisted},
	             {"boundary_faces", sums.boundary_faces - stats.borders.faces_elsewhere},
	             {"boundary_area", stats.measure.boundary_area},
	             {"boundary_mean", orNull(stats.measure.boundary_mean)},
	             {"boundary_flux", stats.flux ? nlohmann::json(stats.flux->boundary) : nlohmann::json()},
	             {"nan_area", stats.measure.nan_area},
	             {"flux", stats.flux ? nlohmann::json(stats.flux->through) : nlohmann::json()},
	             {"crinkle", crinkleJson(stats)}});
	if (stats.overlap && session::isMuch(*stats.overlap))
		json["overlap_area"] = stats.overlap->area;
	if (stats.value_areas)
		addLabels(session, *sheet.field, *stats.value_areas, json);
	if (stats.traces)
		json["vectors"] = tracesJson(session, *stats.traces);
	return json;
}

} // namespace

nlohmann::json sheetsJson(const session::Session& session, const cut::Cut& slice,
                          const std::vector<session::SheetStats>& sheets)
{
	nlohmann::json list = nlohmann::json::array();
	for (std::size_t s = 0; s < sheets.size(); ++s)
		list.push_back(sheetJson(session, slice, s, sheets[s]));
	return list;
}

// Figures of all ranks together.
double areaOf(const session::Session& session, const mesh::SheetMesh& mesh)
{
	return measure::measureOf(ranks::sumUp(session.ranks(), session.blocks(), mesh, {}), false).area;
}

nlohmann::json contoursJson(const session::Session& session, const session::Contours& contours)
{
	nlohmann::json list = nlohmann::json::array();
	for (std::size_t s = 0; s < contours.size(); ++s)
		for (const ranks::GrownContour& contour : contours[s])
			list.push_back({{"sheet", s},
			                {"value", contour.value},
			                {"cells", contour.cells},
			                {"polygons", contour.mesh.polygons()},
			                {"area", areaOf(session, contour.mesh)},
			                {"components", contour.components},
			                {"seeds", contour.seeds},
			                {"generations", contour.generations},
			                {"cells_touched", contour.cells_touched}});
	return list;
}

// From how many cells on `--classify auto` has the device do it; null where it was not asked, or is never faster.
nlohmann::json breakEvenJson(const session::Session& session)
{
	return session.breakEven() && session.breakEven()->cells ? nlohmann::json(*session.breakEven()->cells)
	                                                         : nlohmann::json();
}

nlohmann::json partsJson(const session::Session& session)
{
	const std::optional<parts::PartUse> use = grid::partUse(session.blocks());
	if (!use)
		return {};
	return {{"all", use->all},
	        {"met", use->met},
	        {"read", use->read},
	        {"kept", use->kept},
	        {"bytes_read", use->bytes_read},
	        {"bytes_met", use->bytes_met},
	        {"level", session.spec().input.level}};
}

nlohmann::json inputJson(const session::Session& session)
{
	const ranks::Share::Counts counts = ranks::countsOf(session.ranks(), session.blocks());
	return {{"input", fmt::format("{}", fmt::join(session.spec().input.files, " "))},
	        {"grid",
	         {{"kind", counts.kind},
	          {"cells", counts.cells},
	          {"points", counts.points},
	          {"linear_cells", counts.linear_cells},
	          {"linear_points", counts.linear_points},
	          {"blocks", counts.blocks},
	          {"cells_without_place", session.blocks().unplaced}}},
	        {"array",
	         session.view().field ? nlohmann::json(session.view().field->title(session.blocks())) : nlohmann::json()},
	        {"sandbox", read::sandboxText()},
	        {"version", kVersion},
	        {"device", session.device() ? session.device()->name() : "none"},
	        {"driver", session.device() ? nlohmann::json(gpu::driverName(*session.device())) : nlohmann::json()},
	        {"classifier", classifierName(session)},
	        {"break_even_cells", breakEvenJson(session)},
	        {"plan", planJson(session)}};
}

std::string statsDocument(const session::Session& session, const nlohmann::json& what)
{
	const Timeline& timeline = *session.timeline();
	nlohmann::json ms = {{"gpu", timeline.totalGpu()}, {"total", timeline.now()}};
	for (const char* section : {"read", "build", "adjacency", "upload", "seed", "refine", "traverse", "emit", "contour",
	                            "trace", "measure", "readback", "render", "write"})
		ms[section] = timeline.total(section);

	nlohmann::json document = inputJson(session);
	document.update(what);
	document["ms"] = std::move(ms);
	document = ranks::documentOfAll(session.ranks(), session.blocks(), std::move(document));
	return document.dump(1, '\t', false, nlohmann::json::error_handler_t::replace) + "\n";
}

// What a tolerance has refined; null where there are no curved cells.
nlohmann::json refinedJson(const cut::Cut& slice)
{
	if (!slice.refined)
		return {};
	const cut::RefinedCounts& counts = slice.refined_counts;
	return {{"cells_looked_at", counts.looked_at},
	        {"cells", counts.cells},
	        {"parts", counts.parts},
	        {"unfinished", counts.unfinished}};
}

std::string statsJson(const session::Session& session, const session::Frame& frame)
{
	return statsDocument(session, {{"time", orNull(session.time())},
	                               {"parts", partsJson(session)},
	                               {"contours", contoursJson(session, frame.contours)},
	                               {"refined", refinedJson(frame.slice)},
	                               {"sheets", sheetsJson(session, frame.slice, frame.sheets)}});
}

namespace
{

// A column of the printed table.
struct TableFigure
{
	std::string_view title;
	std::string_view key; // of a sheet in --stats
};

// Flux and what lies in the boundary are shown if a sheet has them.
std::vector<TableFigure> tableFigures(const nlohmann::json& sheets)
{
	std::vector<TableFigure> figures{{"area", "area"}, {"mean", "mean"}, {"min", "min"}, {"max", "max"}};
	const bool has_flux =
	    std::ranges::any_of(sheets, [](const nlohmann::json& sheet) { return sheet["flux"].is_number(); });
	if (has_flux)
		figures.push_back({"flux", "flux"});
	if (std::ranges::any_of(sheets, [](const nlohmann::json& sheet) { return sheet["boundary_area"] > 0.0; }))
	{
		figures.push_back({"boundary area", "boundary_area"});
		figures.push_back({"boundary mean", "boundary_mean"});
		if (has_flux)
			figures.push_back({"boundary flux", "boundary_flux"});
	}
	return figures;
}

} // namespace

std::string statsTable(const session::Session& session, const session::Frame& frame)
{
	const nlohmann::json sheets = ranks::documentOfAll(
	    session.ranks(), session.blocks(), nlohmann::json{{"sheets", sheetsJson(session, frame.slice, frame.sheets)}});
	std::string table =
	    fmt::format("{:>5} {:>10} {:>10} {:>10} {:>6}", "sheet", "cells", "polygons", "vertices", "pieces");
	const std::vector<TableFigure> figures = tableFigures(sheets["sheets"]);
	for (const TableFigure& figure : figures)
		table += fmt::format(" {:>13}", figure.title);
	table += '\n';
	const auto count = [](const nlohmann::json& value) { return value.get<std::size_t>(); };
	const auto number = [](const nlohmann::json& value)
	{ return value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : "-"; };
	std::size_t s = 0;
	for (const nlohmann::json& sheet : sheets["sheets"])
	{
		table += fmt::format("{:>5} {:>10} {:>10} {:>10} {:>6}", s++, count(sheet["cut_cells"]),
		                     count(sheet["polygons"]), count(sheet["vertices"]), count(sheet["components"]));
		for (const TableFigure& figure : figures)
			table += fmt::format(" {:>13}", number(sheet[figure.key]));
		table += '\n';
	}
	const Timeline& timeline = *session.timeline();
	const double cut_ms =
	    timeline.total("seed") + timeline.total("refine") + timeline.total("traverse") + timeline.total("emit");
	table += fmt::format("{}classified on the {}, cut in {} of {}\n",
	                     session.view().field ? fmt::format("array {}, ", session.view().field->title(session.blocks()))
	                                          : "",
	                     classifierName(session), durationText(cut_ms), durationText(timeline.now()));
	return table;
}

} // namespace vp::app
