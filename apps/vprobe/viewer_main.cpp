// vprobe-view: the command `view` of vprobe, which becomes this program for it.

#include "about.h"
#include "commands/commands.h"
#include "program.h"
#include "report/console.h"

int main(int argc, char** argv)
{
	constexpr vp::app::Command kCommands[] = {{"view", vp::app::addView}};
	const vp::app::Program program{"vprobe", // whose command it is: in messages, and in the help
	                               vp::app::kAbout, vp::app::kFooter, kCommands,
	                               [](const std::string& line, vp::app::ExitCode) { vp::app::printLine(line); }};
	return vp::app::runProgram(program, argc, argv);
}
