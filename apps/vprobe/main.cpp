#include "about.h"
#include "commands/commands.h"
#include "program.h"
#include "report/console.h"
#include "viewer_program.h"

int main(int argc, char** argv)
{
	constexpr vp::app::Command kCommands[] = {
#define VP_ADD(name, add) {name, vp::app::add},
	    VP_COMMANDS(VP_ADD)
#undef VP_ADD
	};
	const vp::app::Program program{"vprobe",
	                               vp::app::kAbout,
	                               vp::app::kFooter,
	                               kCommands,
	                               [](const std::string& line, vp::app::ExitCode) { vp::app::printLine(line); },
	                               true,
	                               vp::app::becomeViewer};
	return vp::app::runProgram(program, argc, argv);
}
