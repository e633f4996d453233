#include "commands/commands.h"
#include "interact/bindings.h"
#include "options/spec_options.h"
#include "report/stats_json.h"
#include "view/resolve.h"
#include "view/state_file.h"
#include "view/validate.h"
#include "viewer/viewer.h"

#include <fmt/format.h>

#include <memory>

namespace vp::app
{

namespace
{

struct ViewOptions
{
	SpecOptions common;
	std::string stats;
	std::string commands;
	bool list_bindings = false;
};

Result<ExitCode> runView(const ViewOptions& options)
{
	if (options.list_bindings)
	{
		fmt::print("{}", interact::bindingsText());
		return ExitCode::done;
	}
	const view::ViewSpec& spec = options.common.spec;
	// What can be wrong on the command line is told before a window opens.
	if (options.common.wrong)
		return *options.common.wrong;
	if (!spec.input.files.empty())
		if (Status ready = prepare(options.common); !ready)
			return ready.error();
	for (const Status& fits : {checkWritable(options.stats), view::validate(spec)})
		if (!fits)
			return fits.error();
	if (Result<view::ResolvedLook> look = view::resolveLook(spec); !look)
		return look.error();
	const ReadState read_state = [machine = spec.machine](const std::string& file) -> Result<view::ViewSpec>
	{
		view::ViewSpec read;
		read.machine = machine;
		if (Status loaded = view::loadState(read, file); !loaded)
			return loaded.error();
		if (Status fits = view::validate(read); !fits)
			return fits.error();
		return read;
	};
	return runViewer({spec, read_state, options.stats, options.commands});
}

} // namespace

void addView(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ViewOptions>();
	CLI::App* command = program.add_subcommand("view", "Drag a probe through an input, in a window");
	addInputs(*command, options->common)->required(false);
	addProbeOptions(*command, options->common);
	addLookOptions(*command, options->common);
	addVectorOptions(*command, options->common);
	addContourOptions(*command, options->common);
	addPathOptions(*command, options->common);
	addStateOptions(*command, options->common);
	command->add_flag("--list-bindings", options->list_bindings, "Prints what the keys do, and opens no window");
	command
	    ->add_option("--stats", options->stats,
	                 "When the window closes: how fast it was, as JSON (frames, cuts, from input to picture)")
	    ->type_name("FILE|-");
	command
	    ->add_option("--commands", options->commands,
	                 "Carries out the lines of a file while the window runs: docs/VIEWER.md, Scripting")
	    ->type_name("FILE|-");
	command->callback([&run, options] { run = [options] { return runView(*options); }; });
}

} // namespace vp::app
