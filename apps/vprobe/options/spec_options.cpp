#include "options/spec_options.h"

#include "base/input_files.h"
#include "team.h"
#include "view/state_file.h"
#include "view/validate.h"
#include "write/atomic_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace vp::app
{

void addStateOptions(CLI::App& command, SpecOptions& options)
{
	const char* group = "State";
	command
	    .add_option("--save", options.save,
	                "Save input, probe, look and path, as the command line gives them, in a file")
	    ->type_name("FILE.json")
	    ->group(group);
	// The state is read before any other option, so that the other options take precedence over it.
	command
	    .add_option_function<std::string>(
	        "--state",
	        [&options](const std::string& file)
	        {
		        if (Status loaded = view::loadState(options.spec, file); !loaded)
			        options.wrong = loaded.error();
	        },
	        "Use the settings of a saved file. Other options take precedence, and INPUT may be left out")
	    ->trigger_on_parse()
	    ->type_name("FILE.json")
	    ->group(group);
}

Status prepare(const SpecOptions& options)
{
	if (options.wrong)
		return *options.wrong;
	if (options.spec.input.files.empty())
		return Error{ErrorKind::usage, "INPUT is required: name a file, demo:NAME or --state FILE; see vprobe --help"};
	// Outputs are checked from now on, long before the files are read.
	for (const std::string& file : options.spec.input.files)
		noteInput(file);
	noteInput(options.spec.input.solution);
	if (options.save == "-")
		return Error{ErrorKind::usage,
		             "--save -: a state names files relative to its own place; give it a file's name"};
	if (!options.save.empty() && isFirst())
		if (Status place = write::checkWritable(options.save); !place)
			return place;
	return view::validate(options.spec);
}

Status saveSpec(const SpecOptions& options)
{
	return options.save.empty() || !isFirst() ? Nothing{} : view::saveState(options.spec, options.save);
}

Status refuseLook(const CLI::App& command, const std::string& why, const char* remedy)
{
	for (const CLI::Option* option : command.get_options())
		if (option->get_group() == "Look" && option->count() > 0)
			return Error{ErrorKind::usage, fmt::format("{}: says how a picture looks, and {}; {}, or leave it out",
			                                           option->get_name(), why, remedy)};
	return Nothing{};
}

} // namespace vp::app
