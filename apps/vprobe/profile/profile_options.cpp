#include "profile/profile_options.h"

#include "options/arguments.h"

#include <CLI/CLI.hpp>

namespace vp::app
{

Status takeOptions(ProfileOptions& options, const std::string& text)
{
	CLI::App command;
	command.set_help_flag();
	addSettings(command, options.common, "input");
	addProbeOptions(command, options.common);
	addSettings(command, options.common, "look");
	command.add_flag("--draw", options.draw);
	try
	{
		command.parse(joinNumbers(CLI::detail::split_up(text)));
	}
	catch (const CLI::ParseError& error)
	{
		std::string reason = error.what();
		std::ranges::replace(reason, '\n', ' ');
		return Error{ErrorKind::usage, reason};
	}
	if (command.get_option("INPUT")->count() > 0)
		return Error{ErrorKind::usage, "names an input, but all settings measure the same one; give options alone"};
	if (options.common.wrong)
		return *options.common.wrong;
	return options.draw ? Status(Nothing{}) : refuseLook(command, "nothing is drawn", "add --draw");
}

} // namespace vp::app
