#include "saved_options.h"

#include "make_probe.h"
#include "state/state_file.h"
#include "stats_json.h"
#include "write/atomic_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

// The one list of what a state holds: a new option is one line here. A key is the option's name with _ for -.
// What belongs to the machine (--classify, --strategy, --device, --threads) is none of it.
state::Sections sectionsOf(SavedOptions& options)
{
	ProbeOptions& probe = options.probe;
	LookOptions& look = options.look;
	PathOptions& path = options.path;
	return {{"input",
	         {{"files", state::Files{&probe.inputs}},
	          {"time", &probe.time},
	          {"solution", state::File{&probe.solution}},
	          {"refine", &probe.refine},
	          {"displace", &probe.displace}}},
	        {"probe",
	         {{"probe", state::ProbeChoice{&probe.probe, &probe.own_probe}},
	          {"origin", &probe.origin},
	          {"normal", &probe.normal},
	          {"up", &probe.up},
	          {"window", &probe.window},
	          {"surface", &probe.surface},
	          {"crinkle", &probe.crinkle},
	          {"vanes", &probe.vanes},
	          {"offsets", &probe.offsets},
	          {"sheets", &probe.sheets},
	          {"corners", &probe.corners},
	          {"array", &probe.array},
	          {"component", &probe.component},
	          {"threshold", &probe.threshold},
	          {"seeds", &probe.seeds},
	          {"outside", &probe.outside}}},
	        {"look",
	         {{"size", &look.size},
	          {"samples", &look.samples},
	          {"colormap", state::NameOrFile{&look.colormap}},
	          {"color_by", &look.color_by},
	          {"range", &look.range},
	          {"range_of", &look.range_of},
	          {"symmetric", &look.symmetric},
	          {"log", &look.logarithmic},
	          {"opacity", &look.opacity},
	          {"lines", &look.lines},
	          {"no_legend", &look.no_legend},
	          {"no_labels", &look.no_labels},
	          {"bands", &look.bands},
	          {"mesh", &look.mesh},
	          {"lit", &look.lit},
	          {"background", &look.background},
	          {"camera", &look.camera},
	          {"outline", &look.outline},
	          {"context", &look.context},
	          {"axes", &look.axes},
	          {"units", &look.units},
	          {"length_units", &look.length_units},
	          {"title", &look.title}}},
	        {"vectors",
	         {{"vectors", &probe.vectors.kind},
	          {"vector_array", &probe.vectors.array},
	          {"vector_lattice", &probe.vectors.lattice},
	          {"vector_jitter", &probe.vectors.jitter},
	          {"vector_steps", &probe.vectors.steps},
	          {"vector_dt", &probe.vectors.dt},
	          {"vector_direction", &probe.vectors.direction},
	          {"vector_part", &probe.vectors.part},
	          {"path_lines", &probe.vectors.path_lines},
	          {"vector_color", &look.vectors.color},
	          {"vector_colormap", state::NameOrFile{&look.vectors.colormap}},
	          {"vector_width", &look.vectors.width},
	          {"vector_opacity", &look.vectors.opacity}}},
	        {"contours",
	         {{"contour", &look.contour.values},
	          {"contour_at", &look.contour.at},
	          {"contour_depth", &look.contour.depth},
	          {"contour_opacity", &look.contour.opacity}}},
	        {"sweep",
	         {{"path", state::PathChoice{&path.path, &path.own_path}},
	          {"frames", &path.frames},
	          {"fps", &path.per_second},
	          {"there_and_back", &path.there_and_back}}}};
}

// The reason why an option refuses a value, empty where it takes it.
std::string refusal(CLI::Option& option, std::string value)
{
	try
	{
		for (int i = 0;; ++i)
			if (const std::string reason = (*option.get_validator(i))(value); !reason.empty())
				return reason;
	}
	catch (const CLI::OptionNotFound&) // the last validator has been asked
	{
		return {};
	}
}

// A state's values are held against the options of `command`, which has them all.
Status checkAgainst(const CLI::App& command, const state::Sections& sections, const std::string& file)
{
	for (const state::Section& section : sections)
		for (const state::Setting& setting : section.settings)
		{
			std::string name = fmt::format("--{}", setting.key);
			std::ranges::replace(name, '_', '-');
			const CLI::Option* option = command.get_option_no_throw(name);
			if (!option)
				continue;
			const std::vector<std::string> values = state::valuesOf(setting);
			const auto unfit = [&](const std::string& reason) {
				return Error{ErrorKind::input, fmt::format("{}: /{}/{}: {}", file, section.key, setting.key, reason)};
			};
			const int most = option->get_items_expected_max();
			if (!values.empty() && (static_cast<int>(values.size()) < option->get_items_expected_min() ||
			                        static_cast<int>(values.size()) > std::max(most, 1)))
				return unfit(fmt::format("an array of {} where {} numbers belong", values.size(), most));
			for (const std::string& value : values)
				if (const std::string reason = refusal(const_cast<CLI::Option&>(*option), value); !reason.empty())
					return unfit(reason);
		}
	return Nothing{};
}

} // namespace

Status loadState(const CLI::App& command, SavedOptions& options, const std::string& file)
{
	const state::Sections sections = sectionsOf(options);
	if (Status loaded = state::load(sections, file); !loaded)
		return loaded;
	return checkAgainst(*command.get_parent()->get_subcommand("sweep"), sections, file);
}

void addStateOptions(CLI::App& command, SavedOptions& options)
{
	const char* group = "State";
	command
	    .add_option("--save", options.save,
	                "Keeps input, probe, look and path, as the command line says them, in a file")
	    ->type_name("FILE.json")
	    ->group(group);
	// Before any other option is looked at, so that those go before what the file says.
	command
	    .add_option_function<std::string>(
	        "--state",
	        [&command, &options](const std::string& file)
	        {
		        if (Status loaded = loadState(command, options, file); !loaded)
			        options.state_error = loaded.error();
	        },
	        "Brings them back; other options go before what it says, and INPUT may be left out")
	    ->trigger_on_parse()
	    ->type_name("FILE.json")
	    ->group(group);
}

Status requirePlanes(const SavedOptions& options)
{
	for (const auto& [given, name] :
	     {std::pair{options.probe.surface.has_value(), "--surface"}, std::pair{options.probe.crinkle, "--crinkle"}})
		if (given)
			return Error{ErrorKind::usage,
			             fmt::format("{}: is no plane to draw flat or to lay a line through; draw it with "
			                         "vprobe render, or export it as a .vtp",
			                         name)};
	return Nothing{};
}

Status prepare(SavedOptions& options)
{
	if (options.state_error)
		return *options.state_error;
	if (options.probe.inputs.empty())
		return Error{ErrorKind::usage, "INPUT is required: name a file, demo:NAME or --state FILE; see vprobe --help"};
	if (options.save == "-")
		return Error{ErrorKind::usage,
		             "--save -: a state names files relative to its own place; give it a file's name"};
	if (Status place = checkWritable(options.save); !place)
		return place;
	if (Status fits = checkContours(options.look.contour, options.probe); !fits)
		return fits;
	if (Status probe = readProbeFile(options.probe); !probe)
		return probe;
	return readPathFile(options.path);
}

Status saveState(const SavedOptions& options)
{
	// The places of a list are read only where it is saved.
	return options.save.empty() ? Nothing{} : state::save(sectionsOf(const_cast<SavedOptions&>(options)), options.save);
}

} // namespace vp::app
