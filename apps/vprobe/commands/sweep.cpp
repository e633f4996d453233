#include "base/messages.h"
#include "commands/commands.h"
#include "options/spec_options.h"
#include "options/trace_option.h"
#include "report/explain.h"
#include "report/stats_json.h"
#include "session/time_steps.h"
#include "session/times_seen.h"
#include "sweep/sweep_line.h"
#include "team.h"
#include "view/validate.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace vp::app
{

namespace
{

struct SweepOptions
{
	SpecOptions common;
	std::string output;
	std::string exposure;
	std::string stats;
	std::string trace;
	bool resume = false;

	bool exports() const { return output.ends_with(".pvd"); }
	bool draws() const { return (!output.empty() && !exports()) || !exposure.empty(); }
};

Status checkSweepOptions(const SweepOptions& options)
{
	if (options.output.empty() && options.exposure.empty() && options.stats.empty())
		return Error{ErrorKind::usage, "-o: a sweep needs a place; give frames/{frame:04}.png, a film's name, out.pvd, "
		                               "--exposure, or --stats for figures alone"};
	if (options.common.spec.sweep.seconds && !write::isFilm(options.output))
		return Error{ErrorKind::usage, "--seconds: is the length of a film; give one by -o, or leave --seconds out"};
	const bool pictures = std::filesystem::path(options.output).extension() == ".png";
	if (!options.output.empty() && !pictures && !write::isFilm(options.output) && !options.exports())
		return Error{ErrorKind::usage, fmt::format("-o {}: frames are written as .png, films as .mp4, .mkv, .webm or "
		                                           ".gif, polygons as .pvd",
		                                           options.output)};
	if (options.resume && !pictures)
		return Error{ErrorKind::usage,
		             "--resume: only pictures can be gone on with; write them: -o frames/{frame:04}.png"};
	if (!options.exposure.empty() && std::filesystem::path(options.exposure).extension() != ".png")
		return Error{ErrorKind::usage,
		             fmt::format("--exposure {}: is a picture; give the name of a .png file", options.exposure)};
	if (options.stats == "-" && options.trace == "-")
		return Error{ErrorKind::usage,
		             "--stats - and --trace -: standard output takes one thing at a time; name a file for the other"};
	for (const std::string* place : {&options.stats, &options.common.save})
		if (!place->empty())
			if (Status free = write::checkWritable(*place); !free)
				return free;
	return Nothing{};
}

FramePlaces placesOf(const SweepOptions& options)
{
	FramePlaces places{.exposure = options.exposure, .resume = options.resume, .writes = isFirst()};
	if (write::isFilm(options.output))
		places.film = options.output;
	else if (!options.exports())
		places.pictures = options.output;
	return places;
}

Result<std::unique_ptr<SweepProducts>> productsOf(const SweepOptions& options, session::Session& session,
                                                  view::ResolvedLook look, Frames frames)
{
	std::optional<picture::Painter> painter;
	if (options.draws())
	{
		Result<picture::Painter> made = picture::Painter::create(session, std::move(look));
		if (!made)
			return made.error();
		painter.emplace(std::move(*made));
	}
	return SweepProducts::create(session, std::move(painter), std::move(frames),
	                             options.exports() ? options.output : "");
}

Status sweepAlong(const probe::Path& path, const SweepPlan& plan, session::Session& session, SweepProducts& products)
{
	const std::vector<probe::Frame> poses =
	    probe::poses(path, session.view().probe, session.blocks().bounds(), plan.frames);
	// The first picture is there as soon as can be. Only then is built what makes the others fast.
	const auto ask = [&](int frame)
	{
		return session::FrameRequest{.pose = poses[static_cast<std::size_t>(frame)],
		                             .done = probe::progress(path, frame, plan.frames),
		                             .expect = frame > 0 ? session::Expect::more : session::Expect::first_of_many};
	};
	return sweepThrough(plan, ask, session, products);
}

Status sweepOverTimes(SweepPlan plan, session::Session& session, SweepProducts& products)
{
	const std::vector<double> times = session.blocks().times;
	plan.frames = static_cast<int>(times.size());
	plan.cuts_ahead = false; // it changes what is drawn
	if (times.empty())
		return Error{ErrorKind::input, fmt::format("{}: has no times to sweep over; choose another --path",
		                                           session.spec().input.files.front())};
	if (Status fitted = products.fitTimes(session::firstMiddleAndLast(times.size())); !fitted)
		return fitted.error();
	plan.times = &times;
	// If only values differ between times, the cells that were found are kept, and neighbors would not be used.
	const auto ask = [](int) { return session::FrameRequest{.expect = session::Expect::first_of_many}; };
	return sweepThrough(plan, ask, session, products);
}

Result<ExitCode> runSweep(const SweepOptions& options)
{
	const view::ViewSpec& spec = options.common.spec;
	if (Status ready = prepare(options.common); !ready)
		return ready.error();
	// Polygons are written with every array.
	session::OpenOptions how{.expect = session::Expect::first_of_many,
	                         .reads_all_arrays = options.exports(),
	                         .one_cut_a_time = spec.sweep.over_times,
	                         .frames_alone = true};
	how.ranks = processes();
	if (options.common.explain)
		return explain(spec, how);
	for (const Status& fits :
	     {checkWritable(options.stats), checkSweepOptions(options), view::requirePathOfSurface(spec.probe, spec.sweep),
	      view::refuseGenerations(spec.probe, spec.look.color_by)})
		if (!fits)
			return fits.error();
	Result<view::ResolvedLook> look = view::resolveLook(spec);
	if (!look)
		return look.error();
	look->captions = look->captions && options.exposure.empty(); // they would write over each other
	const Result<int> count = view::frameCount(spec.sweep);
	if (!count)
		return count.error();
	if (options.exports() && isFirst())
		if (Result<write::SliceSeries> tried = write::SliceSeries::create(options.output); !tried)
			return tried.error();
	std::optional<Frames> frames;
	const auto makeFrames = [&, size = look->spec.size](int frame_count) -> Status
	{
		Result<Frames> made =
		    Frames::create(placesOf(options), size.width, size.height, view::filmSpeed(spec.sweep, frame_count));
		if (made)
			frames.emplace(std::move(*made));
		return made ? Status(Nothing{}) : made.error();
	};
	if (Status made = makeFrames(std::max(*count, 1)); !made)
		return made.error();
	Result<std::optional<write::TraceFile>> trace = openTrace(options.trace);
	if (!trace)
		return trace.error();

	how.use = options.draws() ? session::DeviceUse::draw : session::DeviceUse::classify;
	how.keep = *trace ? Timeline::Keep::trace : Timeline::Keep::totals;
	Result<std::unique_ptr<session::Session>> opened = session::Session::open(spec, how);
	if (!opened)
		return opened.error();
	session::Session& session = **opened;
	if (Status free = frames->refuseInputs(*count); !free)
		return free.error();
	// Now the number of times is known.
	if (spec.sweep.over_times && spec.sweep.seconds && !session.blocks().times.empty())
		if (Status made = makeFrames(static_cast<int>(session.blocks().times.size())); !made)
			return made.error();
	Result<std::unique_ptr<SweepProducts>> products =
	    productsOf(options, session, std::move(*look), std::move(*frames));
	if (!products)
		return products.error();
	std::optional<FrameFigures> figures;
	if (!options.stats.empty())
	{
		Result<FrameFigures> made = FrameFigures::create(options.stats);
		if (!made)
			return made.error();
		figures.emplace(std::move(*made));
	}
	const bool threads = spec.machine.threads != 1 && session.ranks().mayCallAtOnce(); // one thread is one
	const SweepPlan plan{*count,
	                     threads,
	                     threads,
	                     figures ? &*figures : nullptr,
	                     *trace ? &**trace : nullptr,
	                     (*products)->makesFiles() ? FrameScope::Stop::file : FrameScope::Stop::cut};
	if (Status swept = spec.sweep.over_times ? sweepOverTimes(plan, session, **products)
	                                         : sweepAlong(view::pathOf(spec.sweep), plan, session, **products);
	    !swept)
		return swept.error();
	if (*trace)
		if (Status written = commitTrace(session, **trace); !written)
			return written.error();
	if (Status saved = saveSpec(options.common); !saved)
		return saved.error();
	return figures ? figures->write(session) : ExitCode::done;
}

} // namespace

void addSweep(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SweepOptions>();
	CLI::App* command =
	    program.add_subcommand("sweep", "Sweep a probe through an input: numbered pictures, a film, or an exposure");
	addInputs(*command, options->common)->required(false); // --state may name them
	addProbeOptions(*command, options->common);
	addExplain(*command, options->common);
	addSettings(*command, options->common, "look");
	addSettings(*command, options->common, "vectors");
	addSettings(*command, options->common, "contours");
	addSettings(*command, options->common, "sweep");
	addStateOptions(*command, options->common);
	const char* group = "Sweep";
	command
	    ->add_option("-o,--output", options->output,
	                 "Where the frames go: pictures (frames/{frame:04}.png), a film (.mp4, .mkv, .webm or .gif, "
	                 "through ffmpeg), or polygons (.pvd)")
	    ->type_name("PATTERN|FILM|FILE.pvd")
	    ->group(group);
	command
	    ->add_option("--exposure", options->exposure, "Write one picture of all frames together, as the eye keeps them")
	    ->type_name("FILE.png")
	    ->group(group);
	command->add_flag("--resume", options->resume, "Keep the pictures that are there already, and draw the others")
	    ->group(group);
	command->add_option("--stats", options->stats, "Write the figures of every frame, and times, as JSON")
	    ->type_name("FILE|-")
	    ->group(group);
	addTraceOption(*command, options->trace, group);
	command->callback([&run, options] { run = [options] { return runSweep(*options); }; });
}

} // namespace vp::app
