#include "base/timeline.h"
#include "commands/commands.h"
#include "interrupt.h"
#include "options/arguments.h"
#include "report/console.h"
#include "report/progress_line.h"
#include "version.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

int exitStatus(vp::app::ExitCode code)
{
	return static_cast<int>(code);
}

// Ctrl-C leaves no half-written file.
void endInterrupted(int)
{
	if (vp::app::deferInterrupt())
		return;
	vp::write::removeUnfinishedFiles();
	_exit(exitStatus(vp::app::ExitCode::interrupted));
}

// A mesh is freed and made again for every cut, and a software device does the same with some megabytes for every draw.
// The C library gives such memory back to the system, or keeps it, as its thresholds happen to stand. If it goes back,
// each page is cleared and mapped again, which can take longer than the cut, and ten times as long as the draw.
void keepFreedMemory()
{
#ifdef __GLIBC__
	mallopt(M_MMAP_THRESHOLD, 32 << 20); // the largest that is allowed
	mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

// CLI11's reasons, as one line that names the remedy.
int reportUsage(const CLI::App& program, const CLI::ParseError& error)
{
	std::string reason = error.what();
	std::replace(reason.begin(), reason.end(), '\n', ' ');
	const auto commands = program.get_subcommands();
	const std::string help =
	    commands.empty() ? "vprobe --help" : fmt::format("vprobe {} --help", commands.front()->get_name());
	vp::app::printLine(fmt::format("{}; see {}", reason, help));
	return exitStatus(vp::app::ExitCode::usage);
}

} // namespace

int main(int argc, char** argv)
{
	CLI::App program{"Slices of volume data on any computational grid, by volume probes (Speray and Kennon, 1990).",
	                 "vprobe"};
	program.set_version_flag("--version", vp::app::kVersion);
	program.require_subcommand(1);
	program.footer(
	    "vprobe COMMAND --help tells a command's options. INPUT is a file or demo:NAME[:N], N cells each way;\n"
	    "vprobe info demo: lists the built-in data sets. Try: vprobe render demo:shell --normal 0.3 0.5 0.8 -o "
	    "shell.png");

	keepFreedMemory();
	vp::nameThreadRow("main");
	const vp::MessageListener messages([](vp::Severity, std::string_view line) { vp::app::printLine(line); });
	const vp::app::ProgressLine progress;
	std::signal(SIGINT, endInterrupted);
	std::signal(SIGTERM, endInterrupted);
	vp::app::Run run;
#define VP_ADD(add) vp::app::add(program, run);
	VP_COMMANDS(VP_ADD)
#undef VP_ADD

	// CLI11 would say that a command is missing, not that this one is none.
	const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
	if (argc > 1 && argv[1][0] != '-' &&
	    std::none_of(commands.begin(), commands.end(), [&](const CLI::App* c) { return c->get_name() == argv[1]; }))
	{
		vp::app::printLine(fmt::format("{}: no such command; see vprobe --help", argv[1]));
		return exitStatus(vp::app::ExitCode::usage);
	}
	try
	{
		program.parse(vp::app::joinNumbers(argc, argv));
	}
	catch (const CLI::CallForHelp&)
	{
		fmt::print("{}", program.help());
		return exitStatus(vp::app::ExitCode::done);
	}
	catch (const CLI::CallForVersion&)
	{
		fmt::print("vprobe {}\n", vp::app::kVersion);
		return exitStatus(vp::app::ExitCode::done);
	}
	catch (const CLI::ParseError& error)
	{
		return reportUsage(program, error);
	}

	try
	{
		vp::Result<vp::app::ExitCode> done = run();
		if (done && (std::fflush(stdout) != 0 || std::ferror(stdout)))
			done = vp::Error{vp::ErrorKind::output,
			                 "standard output: cannot be written; make room or choose another place"};
		if (done)
			return exitStatus(*done);
		vp::app::printLine(done.error().message);
		return exitStatus(vp::app::exitCodeOf(done.error().kind));
	}
	catch (const std::bad_alloc&)
	{
		vp::app::printLine("out of memory; use a smaller input or a machine with more memory");
	}
	catch (const std::exception& error)
	{
		vp::app::printLine(error.what());
	}
	return exitStatus(vp::app::ExitCode::output);
}
