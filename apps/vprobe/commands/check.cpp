#include "commands/commands.h"
#include "cut/integrity.h"
#include "grid/check/quality.h"
#include "options/spec_options.h"
#include "report/console.h"
#include "session/session.h"
#include "view/validate.h"
#include "write/marked_cells.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace vp::app
{

namespace
{

constexpr std::size_t kCellsTold = 5;

struct CheckOptions
{
	SpecOptions input;
	bool json = false;
	std::string output;
};

struct Finding
{
	const char* key;
	const char* about;
	std::size_t count;
	bool fault;                       // if false, it is only reported
	std::vector<grid::SetCell> cells; // each cell once, by its number in the file; may be empty
};

// Counts the faces whose points were not merged. Seams between blocks, seams where a structured block closes, and cells
// that have points of their own are left out, because such grids are made that way.
std::size_t unmergedFaces(const grid::BlockSet& blocks, std::vector<grid::SetCell>& cells)
{
	std::size_t count = 0;
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
	{
		const grid::BlockSeams* seams = blocks.interfaces.of(b);
		const auto* grid = std::get_if<grid::UnstructuredGrid>(&blocks.blocks[b].grid);
		if (!seams || !grid || grid::haveOwnPoints(*grid))
			continue;
		std::pair<CellId, std::uint32_t> last{kNoCell, 0};
		for (const grid::SeamLink& link : seams->all())
		{
			if (link.block != b || link.hang != grid::Hang::none || last == std::pair(link.cell, link.face))
				continue;
			last = {link.cell, link.face};
			++count;
			if (cells.empty() || cells.back() != grid::SetCell{b, link.cell})
				cells.push_back({b, link.cell});
		}
	}
	return count;
}

std::int64_t numberOf(const grid::BlockSet& blocks, const grid::SetCell& cell)
{
	return grid::cellNumber(blocks.blocks[cell.block], cell.cell);
}

std::vector<grid::SetCell> inFileOrder(const grid::BlockSet& blocks, std::vector<grid::SetCell> cells)
{
	std::ranges::sort(cells);
	cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
	std::ranges::sort(cells, {},
	                  [&](const grid::SetCell& cell) { return std::pair(cell.block, numberOf(blocks, cell)); });
	return cells;
}

std::vector<Finding> listFindings(const grid::BlockSet& blocks, const grid::Quality& quality,
                                  const cut::SweepFindings& sweep)
{
	std::vector<Finding> findings;
	const auto add = [&](const char* key, const char* about, std::size_t count, std::vector<grid::SetCell> cells,
	                     bool fault = true) {
		findings.push_back({key, about, count, fault && count > 0, inFileOrder(blocks, std::move(cells))});
	};
	const auto addCells = [&](const char* key, const char* about, const std::vector<grid::SetCell>& cells)
	{ add(key, about, cells.size(), cells); };

	addCells("collapsed_cells", "cells with two corners at one place", quality.collapsed);
	add("degenerate_cells", "cells that list corners twice, cut as the simpler cells they are",
	    quality.degenerate.size(), quality.degenerate, false);
	addCells("inverted_cells", "cells turned inside out", quality.inverted);
	addCells("twisted_cells", "cells with a corner turned inside out", quality.twisted);
	addCells("impossible_cases", "cells so warped that a plane cuts a face of theirs twice", sweep.impossible);
	add("coincident_points", "points that lie on another of their block", quality.coincident.size(), {},
	    quality.coincident_at_fault);
	std::vector<grid::SetCell> unmerged;
	const bool at_fault = unmergedFaces(blocks, unmerged) > 0;
	add("seam_faces", "boundary faces that lie on another", blocks.interfaces.seam_faces, std::move(unmerged),
	    at_fault);

	std::vector<grid::SetCell> around;
	for (const auto& cells : quality.nonmanifold_faces)
		around.insert(around.end(), cells.begin(), cells.end());
	add("nonmanifold_faces", "faces of more than two cells", quality.nonmanifold_faces.size(), std::move(around));
	addCells("nonmanifold_edges", "edges with more than two boundary faces", quality.nonmanifold_edges);
	addCells("nonmanifold_points", "points where the boundary touches itself", quality.nonmanifold_points);
	// Such points change no figure: many programs write all points of a mesh but only some of its cells.
	add("orphan_points", "points of no cell", quality.orphans.size(), {}, false);
	std::vector<grid::SetCell> overlapping;
	for (const auto& [a, b] : quality.overlaps)
		overlapping.insert(overlapping.end(), {a, b});
	add("overlaps", "pairs of cells that hold a point in common", quality.overlaps.size(), std::move(overlapping));
	return findings;
}

bool isClean(const std::vector<Finding>& findings)
{
	return std::ranges::none_of(findings, &Finding::fault);
}

nlohmann::json findingsJson(const grid::BlockSet& blocks, const std::vector<Finding>& findings,
                            const cut::SweepFindings& sweep, std::size_t overlap_samples)
{
	nlohmann::json document = {{"clean", isClean(findings)},
	                           {"grid",
	                            {{"kind", blocks.kind()},
	                             {"cells", blocks.cellCount()},
	                             {"points", blocks.pointCount()},
	                             {"blocks", blocks.blocks.size()},
	                             {"cells_without_place", blocks.unplaced}}},
	                           {"interfaces", blocks.interfaces.interfaces.size()},
	                           {"planes_swept", sweep.planes},
	                           {"cells_swept", sweep.cells},
	                           {"overlap_samples", overlap_samples}};
	nlohmann::json faults = nlohmann::json::array();
	nlohmann::json first_cells = nlohmann::json::object();
	for (const Finding& finding : findings)
	{
		document[finding.key] = finding.count;
		if (finding.fault)
			faults.push_back(finding.key);
		for (std::size_t i = 0; i < std::min(kCellsTold, finding.cells.size()); ++i)
			first_cells[finding.key].push_back(
			    {{"block", finding.cells[i].block}, {"cell", numberOf(blocks, finding.cells[i])}});
	}
	document["faults"] = faults;
	document["first_cells"] = first_cells;
	return document;
}

void printFindings(const grid::BlockSet& blocks, const std::vector<Finding>& findings, const cut::SweepFindings& sweep,
                   std::size_t overlap_samples)
{
	const bool several = blocks.blocks.size() > 1;
	for (const Finding& finding : findings)
	{
		if (finding.count == 0)
			continue;
		std::string cells;
		for (std::size_t i = 0; i < std::min(kCellsTold, finding.cells.size()); ++i)
			cells += several ? fmt::format(" {}:{}", finding.cells[i].block, numberOf(blocks, finding.cells[i]))
			                 : fmt::format(" {}", numberOf(blocks, finding.cells[i]));
		if (!cells.empty())
			cells = fmt::format("; {}{}{}", several ? "block:cell" : "cells", cells,
			                    finding.cells.size() > kCellsTold ? " ..." : "");
		print("{:<6} {:>9}  {:<18} {}{}\n", finding.fault ? "fault" : "note", finding.count, finding.key, finding.about,
		      cells);
	}
	print("{} in {} cells; {} planes swept, {} cells looked at for overlaps\n",
	      isClean(findings) ? "no fault" : "faults", blocks.cellCount(), sweep.planes, overlap_samples);
}

Result<ExitCode> runCheck(const CheckOptions& options)
{
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	if (Status level = view::requireLevel(options.input.spec.input, "vprobe check"); !level)
		return level.error();
	if (options.input.spec.input.cell_to_point)
		return Error{ErrorKind::usage, "`cell_to_point`: vprobe check looks at cells, not at arrays; leave it out"};
	if (!options.output.empty() && options.output != "-" && !options.output.ends_with(".vtp"))
		return Error{ErrorKind::usage, fmt::format("-o {}: bad cells are written as .vtp", options.output)};
	if (options.output == "-" && options.json)
		return Error{ErrorKind::usage,
		             "-o - and --json: standard output takes one thing at a time; name a file for the cells"};
	Result<std::unique_ptr<session::Session>> opened = session::Session::open(options.input.spec, {});
	if (!opened)
		return opened.error();
	session::Session& session = **opened;

	const grid::Quality quality = grid::checkQuality(session.blocks());
	Result<cut::SweepFindings> sweep = session.findImpossibleCells();
	if (!sweep)
		return sweep.error();
	const std::vector<Finding> findings = listFindings(session.blocks(), quality, *sweep);

	if (!options.output.empty())
	{
		std::vector<write::MarkedCells> marked;
		for (const Finding& finding : findings)
			if (finding.fault && !finding.cells.empty())
				marked.push_back({finding.key, finding.cells});
		if (Status written = write::writeMarkedCells(session.blocks(), marked, options.output); !written)
			return written.error();
	}
	if (options.json)
		print("{}\n", findingsJson(session.blocks(), findings, *sweep, quality.overlap_samples)
		                  .dump(1, '\t', false, nlohmann::json::error_handler_t::replace));
	else if (options.output != "-")
		printFindings(session.blocks(), findings, *sweep, quality.overlap_samples);
	return isClean(findings) ? ExitCode::done : ExitCode::findings;
}

} // namespace

void addCheck(CLI::App& program, Run& run)
{
	auto options = std::make_shared<CheckOptions>();
	options->input.spec.machine.classify =
	    view::Classify::cpu; // a plane has few cells, so a device pays off only for large grids
	CLI::App* command = program.add_subcommand(
	    "check", "Look for faults of a grid: collapsed, inverted, twisted and overlapping cells, seams");
	addInputs(*command, options->input);
	addSettings(*command, options->input, "machine", Scope::no_cut);
	command->add_flag("--json", options->json, "Write JSON for scripts");
	command
	    ->add_option("-o,--output", options->output,
	                 "Write the faces of the bad cells as .vtp, with the array vprobe:finding")
	    ->type_name("FILE|-");
	command->footer("Exit code 5 when a fault was found. What changes no figure (blocks that meet, points of no cell) "
	                "is told as a note.");
	command->callback([&run, options] { run = [options] { return runCheck(*options); }; });
}

} // namespace vp::app
