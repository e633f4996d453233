#include "base/messages.h"
#include "commands.h"
#include "explain.h"
#include "saved_options.h"
#include "surface_options.h"
#include "sweep_line.h"
#include "time_steps.h"
#include "trace_option.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace vp::app
{

namespace
{

struct SweepOptions
{
	SavedOptions saved;
	std::string output;
	std::string exposure;
	std::string stats;
	std::string trace;
	bool resume = false;

	bool exports() const { return output.ends_with(".pvd"); }
	bool draws() const { return !exports() || !exposure.empty(); }
};

Status checkSweepOptions(const SweepOptions& options)
{
	if (options.output.empty() && options.exposure.empty())
		return Error{ErrorKind::usage,
		             "-o: a sweep needs a place; give frames/{frame:04}.png, a film's name, out.pvd, or --exposure"};
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
	for (const std::string* place : {&options.stats, &options.saved.save})
		if (!place->empty())
			if (Status free = write::checkWritable(*place); !free)
				return free;
	return Nothing{};
}

FramePlaces placesOf(const SweepOptions& options)
{
	FramePlaces places{.exposure = options.exposure, .resume = options.resume};
	if (write::isFilm(options.output))
		places.film = options.output;
	else if (!options.exports())
		places.pictures = options.output;
	return places;
}

Result<std::unique_ptr<SweepProducts>> productsOf(const SweepOptions& options, Session& session, LookChoice look,
                                                  Frames frames)
{
	std::optional<Painter> painter;
	if (options.draws())
	{
		Result<Painter> made = Painter::create(session, options.saved.probe, std::move(look));
		if (!made)
			return made.error();
		painter.emplace(std::move(*made));
	}
	return SweepProducts::create(session, std::move(painter), std::move(frames),
	                             options.exports() ? options.output : "");
}

Result<nlohmann::json> sweepAlong(const probe::Path& path, const ProbeOptions& options, SweepPlan plan,
                                  Session& session, SweepProducts& products)
{
	// The first picture is there as soon as can be. Only then is built what makes the others fast.
	if (session.strategy != find::Strategy::scan)
		plan.build_neighbors = [&] { return buildNeighbors(session, options); };
	const std::vector<probe::Frame> poses = probe::poses(path, session.probe, session.blocks.bounds(), plan.frames);
	const CutSlice cut_slice = [&](int frame, std::shared_ptr<const cut::Cut> last)
	{
		session.probe.frame = poses[static_cast<std::size_t>(frame)];
		session.swept = probe::progress(path, frame, plan.frames);
		session.another_follows = frame > 0;
		return cut(session, std::move(last));
	};
	return sweepThrough(plan, cut_slice, session, products);
}

Result<nlohmann::json> sweepOverTimes(const SweepOptions& options, SweepPlan plan, Session& session,
                                      SweepProducts& products)
{
	TimeSteps steps(session, options.saved.probe, products.painter());
	plan.frames = steps.count();
	plan.cuts_ahead = false; // it changes what is drawn
	if (steps.count() == 0)
		return Error{ErrorKind::input, fmt::format("{}: has no times to sweep over; choose another --path",
		                                           options.saved.probe.inputs.front())};
	if (options.saved.look.range.empty() && options.draws())
		warn("--path times: the colours follow the range of each time; --range LO HI holds them still");
	const CutSlice cut_slice = [&](int frame, const std::shared_ptr<const cut::Cut>&) { return steps.cutAt(frame); };
	return sweepThrough(plan, cut_slice, session, products);
}

Result<ExitCode> runSweep(SweepOptions& options)
{
	if (Status ready = prepare(options.saved); !ready)
		return ready.error();
	options.saved.probe.may_scan = !needsNeighbors(options.saved.look);
	options.saved.probe.reads_all_arrays = options.exports(); // polygons are written with every array
	if (options.saved.probe.explain)
		return explain(options.saved.probe, options.saved.look.color_by == "generation");
	if (Status place = checkWritable(options.stats); !place)
		return place.error();
	if (Status fits = checkSweepOptions(options); !fits)
		return fits.error();
	if (Status fits = requirePathOfSurface(options.saved.probe, options.saved.path); !fits)
		return fits.error();
	Result<LookChoice> look = parseLook(options.saved.look, options.saved.probe.inputs);
	if (!look)
		return look.error();
	if (Status known = refuseGenerations(options.saved.probe, look->by_generation); !known)
		return known.error();
	options.saved.probe.reads_patches = namesPatch(look->context);
	look->captions = options.exposure.empty(); // they would write over each other
	const probe::Path path = pathOf(options.saved.path);
	Result<int> count = frameCount(options.saved.path, path);
	if (!count)
		return count.error();
	if (options.exports())
		if (Result<write::SliceSeries> tried = write::SliceSeries::create(options.output); !tried)
			return tried.error();
	Result<Frames> frames =
	    Frames::create(placesOf(options), look->look.width, look->look.height, options.saved.path.per_second);
	if (!frames)
		return frames.error();

	Result<std::optional<write::TraceFile>> trace = openTrace(options.trace);
	if (!trace)
		return trace.error();
	Result<std::unique_ptr<Session>> opened =
	    openSession(options.saved.probe, options.draws() ? DeviceUse::draw : DeviceUse::classify,
	                *trace ? Timeline::Keep::sections : Timeline::Keep::totals);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	session.range_of_slice = look->range_of_slice;
	if (look->by_generation)
		session.finder = find::Finder::traversal;
	Result<std::unique_ptr<SweepProducts>> products =
	    productsOf(options, session, std::move(*look), std::move(*frames));
	if (!products)
		return products.error();
	const bool threads = options.saved.probe.threads != 1; // one thread is one
	const SweepPlan plan{
	    *count, threads, threads, !options.stats.empty(), *trace ? &**trace : nullptr, options.saved.look.contour, {}};
	Result<nlohmann::json> figures = options.saved.path.overTimes()
	                                     ? sweepOverTimes(options, plan, session, **products)
	                                     : sweepAlong(path, options.saved.probe, plan, session, **products);
	if (!figures)
		return figures.error();
	if (*trace)
		if (Status written = (*trace)->commit(); !written)
			return written.error();
	if (Status saved = saveState(options.saved); !saved)
		return saved.error();
	return writeStats(options.stats, {},
	                  statsDocument(options.saved.probe, session, {{"frames", std::move(*figures)}}));
}

} // namespace

void addSweep(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SweepOptions>();
	CLI::App* command =
	    program.add_subcommand("sweep", "Sweep a probe through an input: numbered pictures, a film, or an exposure");
	addInputs(*command, options->saved.probe)->required(false); // --state may name them
	addProbeOptions(*command, options->saved.probe);
	addExplain(*command, options->saved.probe);
	addLookOptions(*command, options->saved.look);
	addVectorOptions(*command, options->saved.probe.vectors, &options->saved.look.vectors);
	addContourOptions(*command, options->saved.look.contour);
	addPathOptions(*command, options->saved.path);
	addStateOptions(*command, options->saved);
	const char* group = "Sweep";
	command
	    ->add_option("-o,--output", options->output,
	                 "frames/{frame:04}.png, a film: .mp4, .mkv, .webm or .gif (through ffmpeg), or polygons: .pvd")
	    ->type_name("PATTERN|FILM|FILE.pvd")
	    ->group(group);
	command->add_option("--exposure", options->exposure, "All frames in one picture, as the eye keeps them")
	    ->type_name("FILE.png")
	    ->group(group);
	command->add_flag("--resume", options->resume, "Leaves pictures that are there, draws the others")->group(group);
	command->add_option("--stats", options->stats, "Figures of every frame, and times, as JSON")
	    ->type_name("FILE|-")
	    ->group(group);
	addTraceOption(*command, options->trace, group);
	command->callback([&run, options] { run = [options] { return runSweep(*options); }; });
}

} // namespace vp::app
