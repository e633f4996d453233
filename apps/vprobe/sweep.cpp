#include "base/log.h"
#include "base/progress.h"
#include "commands.h"
#include "exposure.h"
#include "painter.h"
#include "probe/path_file.h"
#include "write/film.h"
#include "write/frame_names.h"
#include "write/png.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

namespace vp::app
{

namespace
{

struct SweepOptions
{
	ProbeOptions probe;
	LookOptions look;
	std::string path = "translate"; // or another name, or a .json file
	std::optional<int> frames;
	double per_second = 25.0;
	bool there_and_back = false;
	std::string output;
	std::string exposure;
	std::string stats;
	bool resume = false;
};

Result<probe::Path> pathOf(const SweepOptions& options)
{
	probe::Path path;
	if (const std::optional<probe::PathKind> kind = probe::pathKind(options.path))
		path.kind = *kind;
	else if (options.path.ends_with(".json"))
	{
		Result<probe::Path> read = probe::readPath(options.path);
		if (!read)
			return read;
		path = std::move(*read);
	}
	else
		return Error{ExitCode::usage, fmt::format("--path {}: takes translate, rotate, spin, revolve, profile or a "
		                                          ".json file",
		                                          options.path)};
	path.there_and_back = path.there_and_back || options.there_and_back;
	return path;
}

Result<int> frameCount(const SweepOptions& options, const probe::Path& path)
{
	if (const std::optional<int> frames = options.frames ? options.frames : probe::framesOf(path, options.per_second))
		return *frames;
	return Error{ExitCode::usage,
	             fmt::format("--frames: the path {} does not say how many frames there are; give their "
	                         "number",
	                         options.path)};
}

// Where the frames of a sweep go: pictures, a film, an exposure, or several of them.
class Frames
{
public:
	static Result<Frames> create(const SweepOptions& options, const render::Look& look)
	{
		Frames frames(options);
		if (write::isFilm(options.output))
		{
			Result<write::Film> film = write::Film::create(options.output, look.width, look.height, options.per_second);
			if (!film)
				return film.error();
			frames.film_ = std::make_unique<write::Film>(std::move(*film));
		}
		else if (!options.output.empty())
		{
			Result<write::FrameNames> names = write::FrameNames::create(options.output);
			if (!names)
				return names.error();
			frames.names_ = std::move(*names);
		}
		return frames;
	}

	// --resume: pictures that are there stay. An exposure needs them all.
	bool has(int frame) const
	{
		return options_.resume && options_.exposure.empty() && names_ && std::filesystem::exists(names_->of(frame));
	}
	Status add(int frame, const render::Picture& picture)
	{
		if (exposure_)
			exposure_->add(picture);
		if (names_)
			return write::writePng(picture, names_->of(frame));
		return film_ ? film_->add(picture) : Nothing{};
	}
	bool wantsExposure() const { return !options_.exposure.empty(); }
	void beginExposure(render::Picture empty) { exposure_.emplace(std::move(empty)); }
	Status commit()
	{
		if (exposure_)
			if (Status written = write::writePng(exposure_->picture(), options_.exposure); !written)
				return written;
		return film_ ? film_->commit() : Nothing{};
	}

private:
	explicit Frames(const SweepOptions& options) : options_(options) {}

	const SweepOptions& options_;
	std::optional<write::FrameNames> names_;
	std::unique_ptr<write::Film> film_;
	std::optional<Exposure> exposure_;
};

Status checkOptions(const SweepOptions& options)
{
	if (options.output.empty() && options.exposure.empty())
		return Error{ExitCode::usage,
		             "-o: a sweep needs a place; give frames/{frame:04}.png, a film's name, or --exposure"};
	if (!(options.per_second > 0.0) || !std::isfinite(options.per_second))
		return Error{ExitCode::usage, "--fps: takes a number above 0"};
	if (!options.output.empty() && !write::isFilm(options.output) &&
	    std::filesystem::path(options.output).extension() != ".png")
		return Error{
		    ExitCode::usage,
		    fmt::format("-o {}: frames are written as .png, films as .mp4, .mkv, .webm or .gif", options.output)};
	if (options.resume && write::isFilm(options.output))
		return Error{ExitCode::usage,
		             "--resume: a film cannot be gone on with; write pictures: -o frames/{frame:04}.png"};
	if (!options.exposure.empty() && std::filesystem::path(options.exposure).extension() != ".png")
		return Error{ExitCode::usage,
		             fmt::format("--exposure {}: is a picture; give the name of a .png file", options.exposure)};
	return Nothing{};
}

std::string progressLine(int done, int frames, std::chrono::steady_clock::time_point start)
{
	const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
	return fmt::format("frame {} of {}, {:.0f} s left", done + 1, frames, elapsed.count() / done * (frames - done));
}

// The empty scene, for an exposure.
Result<render::Picture> drawEmpty(Painter& painter, const slice::Slice& first)
{
	slice::Slice nothing;
	for (const slice::SheetSlice& sheet : first.sheets)
		nothing.sheets.push_back({sheet.shown, sheet.sheet, sheet.corners, sheet.field, {}, {}, nullptr});
	return painter.draw(nothing, std::vector<SheetStats>(nothing.sheets.size()));
}

Result<ExitCode> runSweep(const SweepOptions& options)
{
	if (Status fits = checkOptions(options); !fits)
		return fits.error();
	Result<LookChoice> look = parseLook(options.look, options.probe.inputs);
	if (!look)
		return look.error();
	look->captions = options.exposure.empty(); // they would write over each other
	Result<probe::Path> path = pathOf(options);
	if (!path)
		return path.error();
	Result<int> frames = frameCount(options, *path);
	if (!frames)
		return frames.error();
	Result<Frames> out = Frames::create(options, look->look);
	if (!out)
		return out.error();

	Result<std::unique_ptr<Session>> opened = openSession(options.probe, DeviceUse::draw);
	if (!opened)
		return opened.error();
	Session& session = **opened;
	Result<Painter> painter = Painter::create(session, options.probe, std::move(*look));
	if (!painter)
		return painter.error();

	nlohmann::json told = nlohmann::json::array();
	int empty = 0;
	const auto start = std::chrono::steady_clock::now();
	Progress progress(fmt::format("frame 1 of {}", *frames));
	const std::vector<probe::Frame> poses = probe::poses(*path, session.probe, session.blocks.bounds(), *frames);
	for (int frame = 0; frame < *frames; ++frame)
	{
		if (frame > 0)
			progress.say(progressLine(frame, *frames, start));
		if (out->has(frame))
			continue;
		session.probe.frame = poses[static_cast<std::size_t>(frame)];
		Result<slice::Slice> slice = cut(session);
		if (!slice)
			return slice.error();
		const std::vector<SheetStats> sheets = sheetStats(session, *slice);
		if (frame == 0 && out->wantsExposure())
		{
			Result<render::Picture> background = drawEmpty(*painter, *slice);
			if (!background)
				return background.error();
			out->beginExposure(std::move(*background));
		}
		Result<render::Picture> picture = painter->draw(*slice, sheets);
		if (!picture)
			return picture.error();
		if (Status written = out->add(frame, *picture); !written)
			return written.error();
		empty += std::ranges::all_of(slice->sheets, isEmpty);
		if (!options.stats.empty())
			told.push_back({{"frame", frame}, {"sheets", sheetsJson(session, *slice, sheets)}});
	}
	if (Status written = out->commit(); !written)
		return written.error();
	if (empty > 0)
		warn("{} of {} frames are empty: the probe misses the grid there", empty, *frames);
	return writeStats(options.stats, "", statsDocument(options.probe, session, "frames", std::move(told)));
}

} // namespace

void addSweep(CLI::App& program, Run& run)
{
	auto options = std::make_shared<SweepOptions>();
	CLI::App* command =
	    program.add_subcommand("sweep", "Sweep a probe through an input: numbered pictures, a film, or an exposure");
	addInputs(*command, options->probe);
	addProbeOptions(*command, options->probe);
	addLookOptions(*command, options->look);
	const char* group = "Sweep";
	command
	    ->add_option(
	        "--path", options->path,
	        "translate along the normal, rotate about the up axis, spin about the normal, revolve from vane to "
	        "vane, profile (the benchmark's), or a file (docs/PROBES.md)")
	    ->type_name("NAME|FILE.json")
	    ->capture_default_str()
	    ->group(group);
	command->add_option("--frames", options->frames, "Number of frames")
	    ->check(CLI::Range(1, probe::kMaxFrames))
	    ->type_name("N")
	    ->group(group);
	command->add_option("--fps", options->per_second, "Frames a second, of films and of paths in seconds")
	    ->capture_default_str()
	    ->group(group);
	command->add_flag("--there-and-back", options->there_and_back, "And back again")->group(group);
	command
	    ->add_option("-o,--output", options->output,
	                 "frames/{frame:04}.png, or a film: .mp4, .mkv, .webm or .gif (through ffmpeg)")
	    ->type_name("PATTERN|FILM")
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
