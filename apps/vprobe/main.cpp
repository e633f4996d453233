#include "commands/commands.h"
#include "program.h"
#include "report/console.h"

int main(int argc, char** argv)
{
	const vp::app::Program program{
	    "vprobe",
	    "Slices of volume data on any computational grid, by volume probes (Speray and Kennon, 1990).",
	    "vprobe COMMAND --help tells a command's options. vprobe INPUT opens a window. INPUT is a file or "
	    "demo:NAME[:N], N cells each way;\n"
	    "vprobe info demo: lists the built-in data sets. Try: vprobe render demo:shell --normal 0.3 0.5 0.8 -o "
	    "shell.png",
	    {
#define VP_ADD(add) vp::app::add,
	        VP_COMMANDS(VP_ADD)
#undef VP_ADD
	    },
	    [](const std::string& line, vp::app::ExitCode) { vp::app::printLine(line); },
	    true};
	return vp::app::runProgram(program, argc, argv);
}
