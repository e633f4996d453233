#include "options/option_values.h"
#include "probe/path_file.h"
#include "view/settings.h"

namespace vp::app
{

void addPathOptions(CLI::App& command, SpecOptions& options)
{
	view::SweepSpec& sweep = options.spec.sweep;
	const char* group = "Sweep";
	addText(
	    command, options, "--path", [&sweep](const std::string& name) { return choosePath(sweep, name); },
	    "translate along the normal, rotate about the up axis, spin about the normal, revolve from vane to "
	    "vane, profile (the benchmark's), times (a frame for each time of the input), or a file "
	    "(docs/PROBES.md)")
	    ->type_name("NAME|FILE.json")
	    ->default_str(view::pathKindText(sweep))
	    ->group(group);
	command.add_option("--frames", sweep.frames, "Number of frames")->type_name("N")->group(group);
	command
	    .add_option("--fps", sweep.frames_per_second,
	                "Frames per second, for films and for paths whose times are in seconds")
	    ->capture_default_str()
	    ->group(group);
	command.add_flag("--there-and-back", sweep.there_and_back, "Go back to the start at the end")->group(group);
}

Status choosePath(view::SweepSpec& sweep, const std::string& name)
{
	if (!name.ends_with(".json"))
		return view::setPathKind(sweep, name);
	Result<probe::Path> read = probe::readPath(name);
	if (!read)
		return read.error();
	sweep.own = std::move(*read);
	sweep.over_times = false;
	return Nothing{};
}

} // namespace vp::app
