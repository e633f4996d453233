#include "commands.h"
#include "explain.h"
#include "grown_contours.h"
#include "interrupt.h"
#include "make_probe.h"
#include "plane_pictures.h"
#include "saved_options.h"
#include "stats_json.h"
#include "surface_options.h"
#include "vectors_out.h"
#include "write/line_file.h"
#include "write/slice_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace vp::app
{

namespace
{

struct SliceOptions
{
	SavedOptions saved;
	std::string output;
	std::string stats;
	std::string vectors_out;
	std::vector<double> line; // none, or where it begins and ends on the sheet
	int line_sheet = 0;
};

// Told before a large file is read: what does not go with --line.
Status checkLine(const SliceOptions& options, const CLI::App& command)
{
	if (options.line.empty())
		return command.get_option("--sheet")->count() == 0
		           ? Status(Nothing{})
		           : Error{ErrorKind::usage, "--sheet: says on which sheet a --line lies; give one, or leave it out"};
	if (Status finite = requireFinite(options.line, "--line"); !finite)
		return finite;
	constexpr double kFarthest = 1e100; // as in files of probes
	if (std::ranges::any_of(options.line, [](double x) { return std::abs(x) > kFarthest; }))
		return Error{ErrorKind::usage, "--line: places lie within 1e100; give smaller numbers"};
	if (options.line[0] == options.line[2] && options.line[1] == options.line[3])
		return Error{ErrorKind::usage, "--line: begins where it ends; give it a length"};
	const bool fits = options.output == "-" || std::filesystem::path(options.output).extension() == ".csv";
	return fits ? Status(Nothing{})
	            : Error{ErrorKind::usage,
	                    "--line: the values along it are written as .csv; name such a file with -o, or -"};
}

Status writeLineFile(const Session& session, const SliceOptions& options, const cut::Cut& slice,
                     const std::vector<SheetStats>& sheets)
{
	const auto sheet = static_cast<std::size_t>(options.line_sheet);
	return write::writeLine(session.blocks, slice.sheets[sheet].sheet, sheets[sheet].mesh,
	                        {{options.line[0], options.line[1]}, {options.line[2], options.line[3]}}, options.output);
}

// White paper, unless a background is asked for.
Result<LookChoice> planeLook(const SliceOptions& options, const CLI::App& command)
{
	LookOptions look = options.saved.look;
	if (look.background == LookOptions().background && command.get_option("--background")->count() == 0)
		look.background = "white";
	return parseLook(look, options.saved.probe.inputs);
}

// Of pictures, or of polygons; gives the files.
Result<std::vector<std::string>> writeSlices(const Session& session, const SliceOptions& options,
                                             const LookChoice& look, const cut::Cut& slice,
                                             const std::vector<SheetStats>& sheets, const Contours& contours)
{
	const TimedSection section(session.timeline.get(), "write");
	const DeferredInterrupt writing; // the files of a .vtm appear together
	if (namesPictures(options.output))
		return writePictures(session, options.saved.probe.inputs, look, slice, sheets, options.output);
	if (!options.line.empty())
	{
		if (Status written = writeLineFile(session, options, slice, sheets); !written)
			return written.error();
		return std::vector{options.output};
	}
	if (Status written =
	        write::writeSlice(session.blocks, exportedMeshes(sheets), options.output, contourPieces(contours));
	    !written)
		return written.error();
	return std::vector{options.output};
}

Result<ExitCode> runSlice(SliceOptions& options, const CLI::App& command)
{
	if (Status ready = prepare(options.saved); !ready)
		return ready.error();
	if (Status place = checkWritable(options.stats); !place)
		return place.error();
	if (Status one = requireOneSurface(options.saved.probe); !one)
		return one.error();
	options.saved.probe.may_scan = !needsNeighbors(options.saved.look);
	// Polygons are written with every array; and where arrays jump between blocks, vertices are not joined.
	options.saved.probe.reads_all_arrays = !namesPictures(options.output);
	options.saved.probe.reads_again = false;
	if (options.saved.probe.explain)
		return explain(options.saved.probe);
	if (options.output == "-" && options.stats == "-")
		return Error{ErrorKind::usage,
		             "-o - and --stats -: standard output takes one thing at a time; name a file for the other"};
	if (Status fits = checkVectorsOut(options.saved.probe.vectors, options.vectors_out,
	                                  {{"-o", options.output}, {"--stats", options.stats}});
	    !fits)
		return fits.error();
	if (Status fits = checkLine(options, command); !fits)
		return fits.error();
	const bool pictures = namesPictures(options.output);
	if (Status planes = pictures || !options.line.empty() ? requirePlanes(options.saved) : Nothing{}; !planes)
		return planes.error();
	if (pictures && options.saved.probe.vectors.on())
		return Error{ErrorKind::usage, "--vectors: flat pictures show none; draw them with vprobe render"};
	const std::string why =
	    options.output.empty() ? "no -o asks for one" : fmt::format("-o {} is none", options.output);
	if (Status fits = pictures ? Nothing{} : refuseLook(command, why, "write a .png, .svg or .pdf"); !fits)
		return fits.error();
	Result<LookChoice> look = pictures ? planeLook(options, command) : LookChoice{};
	if (!look)
		return look.error();
	if (!options.output.empty() && !pictures)
		if (Result<write::SliceFormat> format = write::sliceFormatOf(options.output); !format)
			return format.error();

	Result<std::unique_ptr<Session>> opened = openSession(options.saved.probe, DeviceUse::classify);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	if (!options.line.empty() && static_cast<std::size_t>(options.line_sheet) >= session.probe.sheets.size())
		return Error{ErrorKind::usage, fmt::format("--sheet {}: there are {}, counted from 0", options.line_sheet,
		                                           session.probe.sheets.size())};
	if (pictures)
		if (auto names = pictureNames(options.output, session.probe.sheets.size()); !names)
			return names.error();
	Result<cut::Cut> slice = cut(session);
	if (!slice)
		return slice.error();
	if (Status told = reportWarnings(session, *slice); !told)
		return told.error();
	Result<std::vector<SheetStats>> stats = sheetStats(session, *slice);
	if (!stats)
		return stats.error();
	const std::vector<SheetStats>& sheets = *stats;

	const Result<Contours> contours = growContours(session, *slice, sheets, options.saved.look.contour, Tell::all);
	if (!contours)
		return contours.error();

	std::vector<std::string> written;
	if (!options.output.empty())
	{
		Result<std::vector<std::string>> files = writeSlices(session, options, *look, *slice, sheets, *contours);
		if (!files)
			return files.error();
		written = std::move(*files);
	}
	if (Status vectors = writeVectors(session, sheets, options.vectors_out); !vectors)
		return vectors.error();
	written.push_back(options.vectors_out);
	if (options.output.empty() && options.stats.empty() && options.vectors_out.empty())
		fmt::print("{}", statsTable(session, *slice, sheets));
	if (Status saved = saveState(options.saved); !saved)
		return saved.error();
	return writeStats(
	    options.stats, written,
	    statsJson(options.saved.probe, session, *slice, sheets, {{"contours", contoursJson(session, *contours)}}));
}

} // namespace

void addSlice(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SliceOptions>();
	CLI::App* command = program.add_subcommand(
	    "slice", "Cut an input by a plane: polygons with every array, a flat picture of each sheet, and figures");
	addInputs(*command, options->saved.probe)->required(false); // --state may name them
	addProbeOptions(*command, options->saved.probe);
	addExplain(*command, options->saved.probe);
	command
	    ->add_option("-o,--output", options->output,
	                 "Polygons as .vtp, .vtm (a .vtp a sheet), .ply or .csv; - writes VTP to standard output. Or a "
	                 "flat picture of "
	                 "each sheet as .png, .svg or .pdf, with {sheet} in the name where there are several")
	    ->type_name("FILE|-");
	command->add_option("--stats", options->stats, "Figures and times as JSON")->type_name("FILE|-");
	command
	    ->add_option("--line", options->line,
	                 "Writes the values along a line through a sheet as .csv instead: from U0 V0 to U1 V1, along the "
	                 "sheet's x and y axes from its origin")
	    ->expected(4)
	    ->allow_extra_args(false)
	    ->type_name("U0 V0 U1 V1");
	command->add_option("--sheet", options->line_sheet, "The sheet of --line, from 0")
	    ->check(CLI::Range(0, static_cast<int>(probe::kMaxSheets) - 1))
	    ->type_name("K");
	command->footer("With neither -o, --stats nor --vectors-out a short table is printed.");
	addLookOptions(*command, options->saved.look, LookScope::plane);
	addVectorOptions(*command, options->saved.probe.vectors, nullptr);
	addVectorsOut(*command, options->vectors_out);
	addContourOptions(*command, options->saved.look.contour);
	addStateOptions(*command, options->saved);
	command->callback([&run, options, command] { run = [options, command] { return runSlice(*options, *command); }; });
}

} // namespace vp::app
