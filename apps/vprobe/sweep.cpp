#include "base/log.h"
#include "base/progress.h"
#include "commands.h"
#include "frames.h"
#include "interrupt.h"
#include "painter.h"
#include "remaining_time.h"
#include "saved_options.h"
#include "surface_options.h"
#include "time_steps.h"
#include "write/slice_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
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
	bool resume = false;

	bool exports() const { return output.ends_with(".pvd"); }
	bool draws() const { return !exports() || !exposure.empty(); }
};

Status checkOptions(const SweepOptions& options)
{
	if (options.output.empty() && options.exposure.empty())
		return Error{ExitCode::usage,
		             "-o: a sweep needs a place; give frames/{frame:04}.png, a film's name, out.pvd, or --exposure"};
	const bool pictures = std::filesystem::path(options.output).extension() == ".png";
	if (!options.output.empty() && !pictures && !write::isFilm(options.output) && !options.exports())
		return Error{ExitCode::usage, fmt::format("-o {}: frames are written as .png, films as .mp4, .mkv, .webm or "
		                                          ".gif, polygons as .pvd",
		                                          options.output)};
	if (options.resume && !pictures)
		return Error{ExitCode::usage,
		             "--resume: only pictures can be gone on with; write them: -o frames/{frame:04}.png"};
	if (!options.exposure.empty() && std::filesystem::path(options.exposure).extension() != ".png")
		return Error{ExitCode::usage,
		             fmt::format("--exposure {}: is a picture; give the name of a .png file", options.exposure)};
	for (const std::string* place : {&options.stats, &options.saved.save})
		if (!place->empty())
			if (Status free = write::tryPlace(*place); !free)
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

// What a sweep makes of its slices, frame by frame.
class Products
{
public:
	static Result<Products> create(const SweepOptions& options, Session& session, LookChoice look, Frames frames)
	{
		Products products(session, std::move(frames));
		if (options.draws())
		{
			Result<Painter> painter = Painter::create(session, options.saved.probe, std::move(look));
			if (!painter)
				return painter.error();
			products.painter_.emplace(std::move(*painter));
		}
		if (options.exports())
		{
			products.interrupt_ = std::make_unique<DeferredInterrupt>();
			Result<write::SliceSeries> series = write::SliceSeries::create(options.output);
			if (!series)
				return series.error();
			products.series_.emplace(std::move(*series));
		}
		return products;
	}

	bool has(int frame) const { return frames_.has(frame); }
	Painter* painter() { return painter_ ? &*painter_ : nullptr; }

	Status add(int frame, const slice::Slice& slice, const std::vector<SheetStats>& sheets)
	{
		if (interrupt_ && interrupt_->came())
			return Error{ExitCode::interrupted, "interrupted; nothing is written"};
		if (series_)
		{
			if (Status written = series_->add(frame, session_.blocks, exportedMeshes(sheets)); !written)
				return written;
		}
		return painter_ ? draw(frame, slice, sheets) : Nothing{};
	}

	Status commit()
	{
		if (Status written = frames_.commit(); !written)
			return written;
		return series_ ? series_->commit() : Nothing{};
	}

private:
	Products(Session& session, Frames frames) : session_(session), frames_(std::move(frames)) {}

	Status draw(int frame, const slice::Slice& slice, const std::vector<SheetStats>& sheets)
	{
		if (frame == 0 && frames_.wantsExposure())
		{
			Result<render::Picture> empty = painter_->drawEmpty(slice, sheets);
			if (!empty)
				return empty.error();
			frames_.beginExposure(std::move(*empty));
		}
		Result<render::Picture> picture = painter_->draw(slice, sheets);
		if (!picture)
			return picture.error();
		return frames_.add(frame, *picture);
	}

	Session& session_;
	Frames frames_;
	std::optional<Painter> painter_;
	std::unique_ptr<DeferredInterrupt> interrupt_;
	std::optional<write::SliceSeries> series_;
};

// The next frame's slice.
using CutFrame = std::function<Result<slice::Slice>(int frame)>;

// Cuts frame by frame. The figures of every frame, where they are wanted.
Result<nlohmann::json> sweepThrough(int frames, const CutFrame& cut_frame, const Session& session, Products& products,
                                    bool wants_figures)
{
	nlohmann::json figures = nlohmann::json::array();
	int empty = 0;
	RemainingTime remaining(static_cast<std::size_t>(frames));
	Progress progress(remaining.line());
	for (int frame = 0; frame < frames; ++frame)
	{
		if (products.has(frame))
		{
			remaining.skip();
			continue;
		}
		progress.say(remaining.line());
		Result<slice::Slice> slice = cut_frame(frame);
		if (!slice)
			return slice.error();
		const std::vector<SheetStats> sheets = sheetStats(session, *slice);
		if (Status added = products.add(frame, *slice, sheets); !added)
			return added.error();
		remaining.done();
		empty += std::ranges::all_of(slice->sheets, isEmpty);
		if (wants_figures)
			figures.push_back({{"frame", frame}, {"sheets", sheetsJson(session, *slice, sheets)}});
	}
	if (Status written = products.commit(); !written)
		return written.error();
	if (empty > 0)
		warn("{} of {} frames are empty: the probe misses the grid there", empty, frames);
	return figures;
}

Result<nlohmann::json> sweepAlong(const probe::Path& path, int frames, Session& session, Products& products,
                                  bool wants_figures)
{
	const std::vector<probe::Frame> poses = probe::poses(path, session.probe, session.blocks.bounds(), frames);
	const CutFrame cut_frame = [&](int frame)
	{
		session.probe.frame = poses[static_cast<std::size_t>(frame)];
		session.swept = probe::progress(path, frame, frames);
		return cut(session);
	};
	return sweepThrough(frames, cut_frame, session, products, wants_figures);
}

Result<nlohmann::json> sweepOverTimes(const SweepOptions& options, Session& session, Products& products,
                                      bool wants_figures)
{
	TimeSteps steps(session, options.saved.probe, products.painter());
	if (steps.count() == 0)
		return Error{ExitCode::input, fmt::format("{}: has no times to sweep over; choose another --path",
		                                          options.saved.probe.inputs.front())};
	if (options.saved.look.range.empty() && options.draws())
		warn("--path times: the colours follow the range of each time; --range LO HI holds them still");
	const CutFrame cut_frame = [&](int frame) { return steps.cutAt(frame); };
	return sweepThrough(steps.count(), cut_frame, session, products, wants_figures);
}

Result<ExitCode> runSweep(SweepOptions& options)
{
	if (Status ready = prepare(options.saved); !ready)
		return ready.error();
	if (Status place = tryPlace(options.stats); !place)
		return place.error();
	if (Status fits = checkOptions(options); !fits)
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

	Result<std::unique_ptr<Session>> opened =
	    openSession(options.saved.probe, options.draws() ? DeviceUse::draw : DeviceUse::classify);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	session.crinkle = options.saved.probe.crinkle;
	if (look->by_generation)
		session.finder = slice::Finder::traversal;
	Result<Products> products = Products::create(options, session, std::move(*look), std::move(*frames));
	if (!products)
		return products.error();
	const bool wants_figures = !options.stats.empty();
	Result<nlohmann::json> figures = options.saved.path.overTimes()
	                                     ? sweepOverTimes(options, session, *products, wants_figures)
	                                     : sweepAlong(path, *count, session, *products, wants_figures);
	if (!figures)
		return figures.error();
	if (Status saved = saveState(options.saved); !saved)
		return saved.error();
	return writeStats(options.stats, {}, statsDocument(options.saved.probe, session, "frames", std::move(*figures)));
}

} // namespace

void addSweep(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SweepOptions>();
	CLI::App* command =
	    program.add_subcommand("sweep", "Sweep a probe through an input: numbered pictures, a film, or an exposure");
	addInputs(*command, options->saved.probe)->required(false); // --state may name them
	addProbeOptions(*command, options->saved.probe);
	addLookOptions(*command, options->saved.look);
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
	command->callback([&run, options] { run = [options] { return runSweep(*options); }; });
}

} // namespace vp::app
