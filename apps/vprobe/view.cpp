#include "commands.h"
#include "interact/bindings.h"
#include "make_probe.h"
#include "saved_options.h"
#include "sheet_traces.h"
#include "stats_json.h"
#include "view/viewer.h"

#include <fmt/format.h>

#include <memory>

namespace vp::app
{

namespace
{

struct ViewOptions
{
	SavedOptions saved;
	std::string stats;
	std::string commands;
	bool list_bindings = false;
};

Result<ExitCode> runView(ViewOptions& options, const CLI::App& command)
{
	if (options.list_bindings)
	{
		fmt::print("{}", interact::bindingsText());
		return ExitCode::done;
	}
	if (options.saved.state_error)
		return *options.saved.state_error;
	if (!options.saved.probe.inputs.empty())
		if (Status ready = prepare(options.saved); !ready)
			return ready.error();
	if (Status place = checkWritable(options.stats); !place)
		return place.error();
	// What can be wrong on the command line is told before a window opens.
	if (Status probe = checkProbeOptions(options.saved.probe); !probe)
		return probe.error();
	if (Status vectors = checkVectors(options.saved.probe); !vectors)
		return vectors.error();
	if (Result<LookChoice> look = parseLook(options.saved.look, options.saved.probe.inputs); !look)
		return look.error();
	const ReadState read_state = [&command](const std::string& file) -> Result<ViewState>
	{
		SavedOptions saved;
		saved.probe.classify = "auto";
		if (Status loaded = loadState(command, saved, file); !loaded)
			return loaded.error();
		if (Status ready = prepare(saved); !ready)
			return ready.error();
		return ViewState{saved.probe, saved.look, saved.path};
	};
	return runViewer(
	    {{options.saved.probe, options.saved.look, options.saved.path}, read_state, options.stats, options.commands});
}

} // namespace

void addView(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ViewOptions>();
	// The window's own threads cut; what the CPU finds without a traversal is what follows the hand.
	options->saved.probe.classify = "auto";
	CLI::App* command = program.add_subcommand("view", "Drag a probe through an input, in a window");
	addInputs(*command, options->saved.probe)->required(false);
	addProbeOptions(*command, options->saved.probe);
	addLookOptions(*command, options->saved.look);
	addVectorOptions(*command, options->saved.probe.vectors, &options->saved.look.vectors);
	addContourOptions(*command, options->saved.look.contour);
	addPathOptions(*command, options->saved.path);
	addStateOptions(*command, options->saved);
	command->add_flag("--list-bindings", options->list_bindings, "Prints what the keys do, and opens no window");
	command
	    ->add_option("--stats", options->stats,
	                 "When the window closes: how fast it was, as JSON (frames, cuts, from input to picture)")
	    ->type_name("FILE|-");
	command
	    ->add_option("--commands", options->commands,
	                 "Carries out the lines of a file while the window runs: docs/VIEWER.md, Scripting")
	    ->type_name("FILE|-");
	command->callback([&run, options, command] { run = [options, command] { return runView(*options, *command); }; });
}

} // namespace vp::app
