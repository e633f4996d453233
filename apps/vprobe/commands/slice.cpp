#include "commands/commands.h"
#include "interrupt.h"
#include "options/spec_options.h"
#include "picture/plane_pictures.h"
#include "ranks/write/joined_tables.h"
#include "report/console.h"
#include "report/explain.h"
#include "report/stats_json.h"
#include "report/vectors_out.h"
#include "session/frame.h"
#include "team.h"
#include "verify/expect.h"
#include "view/validate.h"
#include "write/line_file.h"
#include "write/slice_file.h"

#include <fmt/format.h>

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
	SpecOptions common;
	std::string output;
	std::string stats;
	std::string vectors_out;
	std::string expect;       // figures to compare with
	std::vector<double> line; // empty, or where it begins and ends on the sheet
	int line_sheet = 0;
};

// Checks --line before a large file is read, and that no option was given that does not go with it.
Status checkLine(const SliceOptions& options, const CLI::App& command)
{
	if (options.line.empty())
		return command.get_option("--sheet")->count() == 0
		           ? Status(Nothing{})
		           : Error{ErrorKind::usage, "--sheet: says on which sheet a --line lies; give one, or leave it out"};
	constexpr double kFarthest = 1e100; // as in files of probes
	if (std::ranges::any_of(options.line, [](double x) { return !(std::abs(x) <= kFarthest); }))
		return Error{ErrorKind::usage, "--line: places lie within 1e100; give smaller numbers"};
	if (options.line[0] == options.line[2] && options.line[1] == options.line[3])
		return Error{ErrorKind::usage, "--line: begins where it ends; give it a length"};
	const bool fits = options.output == "-" || std::filesystem::path(options.output).extension() == ".csv";
	return fits ? Status(Nothing{})
	            : Error{ErrorKind::usage,
	                    "--line: the values along it are written as .csv; name such a file with -o, or -"};
}

Status writeLineFile(const session::Session& session, const SliceOptions& options, const session::Frame& frame)
{
	const auto sheet = static_cast<std::size_t>(options.line_sheet);
	const write::SheetLine line{{options.line[0], options.line[1]}, {options.line[2], options.line[3]}};
	const write::SliceTable table = ranks::gathered(
	    session.ranks(), write::tabulateAlong(frame.slice.blocksOf(session.blocks()), frame.slice.sheets[sheet].sheet,
	                                          frame.sheets[sheet].mesh, line));
	return isFirst() ? write::writeLine(table, frame.slice.sheets[sheet].sheet, line, options.output) : Nothing{};
}

// Returns the look of a flat picture. Its background is white unless the user asks for another.
Result<view::ResolvedLook> planeLook(const SliceOptions& options, const CLI::App& command)
{
	view::ViewSpec spec = options.common.spec;
	if (spec.look.background == view::LookSpec().background && command.get_option("--background")->count() == 0)
		spec.look.background = *render::parseBackground("white");
	return view::resolveLook(spec);
}

// Checks the command line before a large file is read.
Status check(const SliceOptions& options, const CLI::App& command)
{
	const view::ProbeSpec& probe = options.common.spec.probe;
	if (options.output == "-" && options.stats == "-")
		return Error{ErrorKind::usage,
		             "-o - and --stats -: standard output takes one thing at a time; name a file for the other"};
	if (Status fits =
	        checkVectorsOut(probe.vectors, options.vectors_out, {{"-o", options.output}, {"--stats", options.stats}});
	    !fits)
		return fits;
	if (Status fits = checkLine(options, command); !fits)
		return fits;
	const bool pictures = picture::namesPictures(options.output);
	if (Status planes = pictures || !options.line.empty() ? view::requirePlanes(probe) : Nothing{}; !planes)
		return planes;
	if (pictures && probe.vectors.on())
		return Error{ErrorKind::usage, "--vectors: flat pictures show none; draw them with vprobe render"};
	if (pictures)
		return Nothing{};
	const std::string why =
	    options.output.empty() ? "no -o asks for one" : fmt::format("-o {} is none", options.output);
	if (Status fits = refuseLook(command, why, "write a .png, .svg or .pdf"); !fits)
		return fits;
	if (!options.output.empty())
		if (Result<write::SliceFormat> format = write::sliceFormatOf(options.output); !format)
			return format.error();
	return Nothing{};
}

// What processes with a part of the data each do not write.
Status checkProcesses(const SliceOptions& options)
{
	if (picture::namesPictures(options.output) && !processes().mayDrawFlat())
		return Error{ErrorKind::usage, fmt::format("-o {}: flat pictures are drawn by one process; use vprobe, or draw "
		                                           "the cut in space by vprobe-mpi render",
		                                           options.output)};
	return ranks::canWrite(processes(), options.output);
}

// Checks what depends on the number of sheets.
Status checkSheets(const SliceOptions& options, std::size_t sheets)
{
	if (!options.line.empty() && static_cast<std::size_t>(options.line_sheet) >= sheets)
		return Error{ErrorKind::usage,
		             fmt::format("--sheet {}: there are {}, counted from 0", options.line_sheet, sheets)};
	if (picture::namesPictures(options.output))
		if (auto names = picture::pictureNames(options.output, sheets); !names)
			return names.error();
	return Nothing{};
}

// Writes pictures, polygons or values along a line. Returns the names of the files.
Result<std::vector<std::string>> writeFiles(const session::Session& session, const SliceOptions& options,
                                            const view::ResolvedLook& look, const session::Frame& frame)
{
	if (options.output.empty())
		return std::vector<std::string>();
	const TimedSection section(session.timeline(), "write");
	const DeferredInterrupt writing; // the files of a .vtm appear together
	if (picture::namesPictures(options.output))
		return picture::writePictures(session, look, frame.slice, frame.sheets, options.output);
	const Status written = !options.line.empty()
	                           ? writeLineFile(session, options, frame)
	                           : ranks::writeSlice(session.ranks(), frame.slice.blocksOf(session.blocks()),
	                                               session::exportedMeshes(frame.sheets), options.output,
	                                               session::contourPieces(frame.contours));
	return written ? Result<std::vector<std::string>>(std::vector{options.output}) : written.error();
}

Result<ExitCode> runSlice(const SliceOptions& options, const CLI::App& command)
{
	const view::ViewSpec& spec = options.common.spec;
	if (Status ready = prepare(options.common); !ready)
		return ready.error();
	if (Status place = checkWritable(options.stats); !place)
		return place.error();
	if (Status one = view::requireOneSurface(spec.probe); !one)
		return one.error();
	const bool pictures = picture::namesPictures(options.output);
	// Polygons are written with every array. Vertices are not joined if arrays jump between blocks.
	const session::OpenOptions how{.expect = session::Expect::one_cut,
	                               .reads_all_arrays = !pictures,
	                               .time_may_change = false,
	                               .frames_alone = true,
	                               .ranks = processes()};
	if (Status fits = checkProcesses(options); !fits)
		return fits.error();
	if (options.common.explain)
		return explain(spec, how);
	if (Status fits = check(options, command); !fits)
		return fits.error();
	if (Status known = checkExpected(options.expect); !known)
		return known.error();
	Result<view::ResolvedLook> look = pictures ? planeLook(options, command) : view::ResolvedLook{};
	if (!look)
		return look.error();

	Result<std::unique_ptr<session::Session>> opened = session::Session::open(spec, how);
	if (!opened)
		return opened.error();
	session::Session& session = **opened;
	if (Status fits = checkSheets(options, session.view().probe.sheets.size()); !fits)
		return fits.error();
	const Result<std::shared_ptr<const session::Frame>> made = session.frame({});
	if (!made)
		return made.error();
	const session::Frame& frame = **made;
	session::reportBoundarySheets(session, frame.sheets);
	session::reportOverlap(session, frame.slice, frame.sheets);
	session::reportRowsAcross(session);
	Result<std::vector<std::string>> written = writeFiles(session, options, *look, frame);
	if (!written)
		return written.error();
	if (Status vectors = writeVectors(session, frame.sheets, options.vectors_out); !vectors)
		return vectors.error();
	written->push_back(options.vectors_out);
	if (options.output.empty() && options.stats.empty() && options.vectors_out.empty() && options.expect.empty())
	{
		const std::string table = statsTable(session, frame);
		if (isFirst())
			print("{}", table);
	}
	if (Status saved = saveSpec(options.common); !saved)
		return saved.error();
	const std::string stats = statsJson(session, frame);
	const Result<ExitCode> done = writeStats(options.stats, *written, stats);
	return done ? compareWith(options.expect, stats) : done;
}

} // namespace

void addSlice(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SliceOptions>();
	CLI::App* command = program.add_subcommand(
	    "slice", "Cut an input by a plane: polygons with every array, a flat picture of each sheet, and figures");
	addInputs(*command, options->common)->required(false); // --state may name them
	addProbeOptions(*command, options->common);
	addExplain(*command, options->common);
	command
	    ->add_option(
	        "-o,--output", options->output,
	        "Where the polygons go: .vtp, .vtm (one .vtp per sheet), .pvtp (one .vtp per process of vprobe-mpi), .ply "
	        "or .csv; - writes VTP to standard output. Or a flat picture of each sheet: .png, .svg or .pdf, with "
	        "{sheet} in the name if there are several sheets")
	    ->type_name("FILE|-");
	command->add_option("--stats", options->stats, "Write figures and times as JSON")->type_name("FILE|-");
	command
	    ->add_option(
	        "--expect", options->expect,
	        "Compare the figures with those of this file, which holds some of the keys of --stats: exit code 6 "
	        "if they differ")
	    ->type_name("FILE.json");
	command
	    ->add_option("--line", options->line,
	                 "Write the values along a line through a sheet as .csv instead. The line goes from U0 V0 to U1 "
	                 "V1, measured along the sheet's x and y axes from its origin")
	    ->expected(4)
	    ->allow_extra_args(false)
	    ->type_name("U0 V0 U1 V1");
	command->add_option("--sheet", options->line_sheet, "The sheet of --line, from 0")
	    ->check(CLI::Range(0, static_cast<int>(probe::kMaxSheets) - 1))
	    ->type_name("K");
	command->footer("With neither -o, --stats, --vectors-out nor --expect a short table is printed.");
	addSettings(*command, options->common, "look", Scope::flat);
	addSettings(*command, options->common, "vectors", Scope::flat);
	addVectorsOut(*command, options->vectors_out);
	addSettings(*command, options->common, "contours");
	addStateOptions(*command, options->common);
	command->callback([&run, options, command] { run = [options, command] { return runSlice(*options, *command); }; });
}

} // namespace vp::app
