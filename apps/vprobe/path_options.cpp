#include "path_options.h"

#include "probe/path_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

namespace vp::app
{

void addPathOptions(CLI::App& command, PathOptions& options)
{
	const char* group = "Sweep";
	command
	    .add_option("--path", options.path,
	                "translate along the normal, rotate about the up axis, spin about the normal, revolve from vane to "
	                "vane, profile (the benchmark's), times (a frame for each time of the input), or a file "
	                "(docs/PROBES.md)")
	    ->type_name("NAME|FILE.json")
	    ->capture_default_str()
	    ->group(group);
	command.add_option("--frames", options.frames, "Number of frames")
	    ->check(CLI::Range(1, probe::kMaxFrames))
	    ->type_name("N")
	    ->group(group);
	command.add_option("--fps", options.per_second, "Frames a second, of films and of paths in seconds")
	    ->capture_default_str()
	    ->group(group);
	command.add_flag("--there-and-back", options.there_and_back, "And back again")->group(group);
}

Status readPathFile(PathOptions& options)
{
	if (options.path.empty())
		return Nothing{};
	options.own_path.reset();
	if (options.overTimes())
		return Nothing{};
	const std::optional<probe::PathKind> kind = probe::pathKind(options.path);
	if (kind && kind != probe::PathKind::keyframes)
		return Nothing{};
	if (kind)
		return Error{ErrorKind::usage,
		             "--path keyframes: keys come from a file; give its name, FILE.json (docs/PROBES.md)"};
	if (!options.path.ends_with(".json"))
		return Error{ErrorKind::usage,
		             fmt::format("--path {}: takes translate, rotate, spin, revolve, profile, times or a .json file",
		                         options.path)};
	Result<probe::Path> read = probe::readPath(options.path);
	if (!read)
		return read.error();
	options.own_path = std::move(*read);
	return Nothing{};
}

probe::Path pathOf(const PathOptions& options)
{
	probe::Path path;
	if (options.own_path)
		path = *options.own_path;
	else if (!options.overTimes())
		path.kind = *probe::pathKind(options.path);
	path.there_and_back = path.there_and_back || options.there_and_back;
	return path;
}

Result<int> frameCount(const PathOptions& options, const probe::Path& path)
{
	if (!(options.per_second > 0.0) || !std::isfinite(options.per_second))
		return Error{ErrorKind::usage, "--fps: takes a number above 0"};
	if (options.overTimes())
		return 0;
	if (const std::optional<int> frames = options.frames ? options.frames : probe::framesOf(path, options.per_second))
		return *frames;
	return Error{ErrorKind::usage,
	             fmt::format("--frames: the path {} does not say how many frames there are; give their number",
	                         options.path.empty() ? probe::nameOf(path.kind) : options.path)};
}

} // namespace vp::app
