#include "base/file_pattern.h"
#include "commands/commands.h"
#include "options/spec_options.h"
#include "picture/painter.h"
#include "report/console.h"
#include "report/explain.h"
#include "report/stats_json.h"
#include "report/vectors_out.h"
#include "session/frame.h"
#include "team.h"
#include "verify/expect.h"
#include "view/validate.h"
#include "write/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace vp::app
{

namespace
{

struct RenderOptions
{
	SpecOptions common;
	std::string output;
	std::string stats;
	std::string vectors_out;
	std::string expect;     // a picture to compare with
	std::string difference; // where the difference is drawn
};

// Returns the picture's name if the user gives none: the input's name, in the current folder.
std::string defaultOutput(const view::InputSpec& input)
{
	std::filesystem::path first = input.files.empty() ? "picture" : input.files.front();
	if (first.filename().empty() || isFilePattern(first.string()))
		first = first.parent_path(); // "slices/" and "slices/*.tif" are called slices
	std::string name = first.empty() ? "picture" : first.filename().string();
	if (name.starts_with("demo:"))
		std::ranges::replace(name, ':', '-');
	else
		name = std::filesystem::path(name).stem().string();
	return name + ".png";
}

// Does not overwrite an existing file, because the user did not name it.
Status takeDefaultOutput(RenderOptions& options)
{
	if (!options.output.empty() || !options.expect.empty())
		return Nothing{};
	options.output = defaultOutput(options.common.spec.input);
	if (!std::filesystem::exists(options.output))
		return Nothing{};
	return Error{ErrorKind::usage,
	             fmt::format("{}: is there already; name the picture by -o, which replaces it", options.output)};
}

// Checks the command line before a large file is read.
Status check(const RenderOptions& options)
{
	const view::ViewSpec& spec = options.common.spec;
	if (Status place = checkWritable(options.stats); !place)
		return place;
	if (options.output == "-" && options.stats == "-")
		return Error{ErrorKind::usage,
		             "-o - and --stats -: standard output takes one thing at a time; name a file for the other"};
	if (!options.output.empty() && options.output != "-" && std::filesystem::path(options.output).extension() != ".png")
		return Error{
		    ErrorKind::usage,
		    fmt::format("-o {}: pictures are written as .png; give a name that ends so, or -", options.output)};
	if (Status fits = checkVectorsOut(spec.probe.vectors, options.vectors_out,
	                                  {{"-o", options.output}, {"--stats", options.stats}});
	    !fits)
		return fits;
	if (Status one = view::requireOneSurface(spec.probe); !one)
		return one;
	return view::refuseGenerations(spec.probe, spec.look.color_by);
}

Result<ExitCode> runRender(RenderOptions& options)
{
	const view::ViewSpec& spec = options.common.spec;
	if (Status ready = prepare(options.common); !ready)
		return ready.error();
	session::OpenOptions how{
	    .expect = session::Expect::one_cut, .reads_all_arrays = false, .time_may_change = false, .frames_alone = true};
	if (options.common.explain)
		return explain(spec, how);
	const bool tells_place = options.output.empty() && options.expect.empty() && options.stats != "-";
	if (Status free = takeDefaultOutput(options); !free)
		return free.error();
	if (Status fits = check(options); !fits)
		return fits.error();
	Result<view::ResolvedLook> look = view::resolveLook(spec);
	if (!look)
		return look.error();
	const Result<ExpectedPicture> expected = readExpected(options.expect, options.difference);
	if (!expected)
		return expected.error();

	how.use = session::DeviceUse::draw;
	how.ranks = processes();
	Result<std::unique_ptr<session::Session>> opened = session::Session::open(spec, how);
	if (!opened)
		return opened.error();
	session::Session& session = **opened;
	const Result<std::shared_ptr<const session::Frame>> made = session.frame({});
	if (!made)
		return made.error();
	const session::Frame& frame = **made;
	session::reportOverlap(session, frame.slice, frame.sheets);
	session::reportRowsAcross(session);
	Result<picture::Painter> painter = picture::Painter::create(session, std::move(*look));
	if (!painter)
		return painter.error();
	Result<render::Picture> picture = painter->draw(frame.slice, frame.sheets, frame.contours);
	if (!picture)
		return picture.error();
	const bool writes = isFirst() && !options.output.empty();
	if (Status written = writes ? write::writePng(*picture, options.output) : Nothing{}; !written)
		return written.error();
	if (tells_place && isFirst())
		print("{}\n", options.output);
	if (Status written = writeVectors(session, frame.sheets, options.vectors_out); !written)
		return written.error();
	if (Status saved = saveSpec(options.common); !saved)
		return saved.error();
	const Result<ExitCode> done =
	    writeStats(options.stats, {options.output, options.vectors_out}, statsJson(session, frame));
	return done ? compareWith(*expected, *picture, spec.look.samples) : done;
}

} // namespace

void addRender(CLI::App& program, Run& run)
{
	auto options = std::make_shared<RenderOptions>();
	CLI::App* command =
	    program.add_subcommand("render", "Draw the cut of an input by a probe, with legend and axes, as a PNG");
	addInputs(*command, options->common)->required(false); // --state may name them
	addProbeOptions(*command, options->common);
	addExplain(*command, options->common);
	command
	    ->add_option("-o,--output", options->output,
	                 "Where the picture goes; - is standard output (default: the input's name, in the current folder)")
	    ->type_name("FILE.png|-");
	command->add_option("--stats", options->stats, "Write figures and times as JSON")->type_name("FILE|-");
	command
	    ->add_option("--expect", options->expect,
	                 "Compare the picture with this one: exit code 6 if they differ. Without -o no picture is written")
	    ->type_name("FILE.png");
	command->add_option("--difference", options->difference, "Where --expect finds a difference, draw it")
	    ->type_name("FILE.png");

	addSettings(*command, options->common, "look");
	addSettings(*command, options->common, "vectors");
	addVectorsOut(*command, options->vectors_out);
	addSettings(*command, options->common, "contours");
	addStateOptions(*command, options->common);
	command->callback([&run, options] { run = [options] { return runRender(*options); }; });
}

} // namespace vp::app
