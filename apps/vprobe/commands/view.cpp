#include "commands/commands.h"
#include "interact/bindings.h"
#include "options/spec_options.h"
#include "options/trace_option.h"
#include "report/console.h"
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
	std::string trace;
	bool list_bindings = false;
};

Result<ExitCode> runView(const ViewOptions& options)
{
	if (options.list_bindings)
	{
		print("{}", interact::bindingsText());
		return ExitCode::done;
	}
	if (options.stats == "-" && options.trace == "-")
		return Error{ErrorKind::usage,
		             "--stats - and --trace -: standard output takes one thing at a time; name a file for the other"};
	const view::ViewSpec& spec = options.common.spec;
	// Errors on the command line are reported before a window opens.
	if (options.common.wrong)
		return *options.common.wrong;
	if (!spec.input.files.empty())
		if (Status ready = prepare(options.common); !ready)
			return ready.error();
	for (const Status& fits :
	     {checkWritable(options.stats), view::validate(spec), view::requireLevel(spec.input, "vprobe view")})
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
		for (const Status& fits : {view::validate(read), view::requireLevel(read.input, "vprobe view")})
			if (!fits)
				return fits.error();
		return read;
	};
	return runViewer({spec, read_state, options.stats, options.commands, options.trace});
}

} // namespace

void addView(CLI::App& program, Run& run)
{
	auto options = std::make_shared<ViewOptions>();
	CLI::App* command = program.add_subcommand("view", "Drag a probe through an input, in a window");
	addInputs(*command, options->common)->required(false);
	addProbeOptions(*command, options->common);
	addSettings(*command, options->common, "look");
	addSettings(*command, options->common, "vectors");
	addSettings(*command, options->common, "contours");
	addSettings(*command, options->common, "sweep");
	addStateOptions(*command, options->common);
	command->add_flag("--list-bindings", options->list_bindings, "Print what the keys do; open no window");
	command
	    ->add_option("--stats", options->stats,
	                 "Write how fast the window was, as JSON, when it closes: frames, cuts, time from input to picture")
	    ->type_name("FILE|-");
	command
	    ->add_option("--commands", options->commands,
	                 "Carry out the lines of a file while the window runs (docs/VIEWER.md, Scripting)")
	    ->type_name("FILE|-");
	addTraceOption(*command, options->trace, "");
	command->callback([&run, options] { run = [options] { return runView(*options); }; });
}

} // namespace vp::app
