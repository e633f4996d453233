#include "program.h"

#include "base/kept_memory.h"
#include "base/timeline.h"
#include "interrupt.h"
#include "options/arguments.h"
#include "options/first_word.h"
#include "report/console.h"
#include "report/progress_line.h"
#include "team.h"
#include "version.h"
#include "write/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <new>
#include <string_view>

#include <unistd.h>

namespace vp::app
{

namespace
{

int exitStatus(ExitCode code)
{
	return static_cast<int>(code);
}

// Ctrl-C leaves no half-written file.
void endInterrupted(int)
{
	if (deferInterrupt())
		return;
	write::removeUnfinishedFiles();
	_exit(exitStatus(ExitCode::interrupted));
}

// Returns CLI11's reason as one line that names the remedy.
std::string usageLine(const std::string& name, const CLI::App& program, const CLI::ParseError& error)
{
	std::string reason = error.what();
	std::replace(reason.begin(), reason.end(), '\n', ' ');
	const auto commands = program.get_subcommands();
	return commands.empty() ? fmt::format("{}; see {} --help", reason, name)
	                        : fmt::format("{}; see {} {} --help", reason, name, commands.front()->get_name());
}

int failed(const Program& program, const std::string& line, ExitCode code)
{
	program.fail(line, code);
	return exitStatus(code);
}

// Ends the program after a help text. Returns the exit status.
int told(const Program& program)
{
	const Status written = flushOutput();
	return written ? exitStatus(ExitCode::done) : failed(program, written.error().message, ExitCode::output);
}

int carryOut(const Program& program, const Run& run)
{
	try
	{
		Result<ExitCode> done = run();
		if (Status written = flushOutput(); done && !written)
			done = written.error();
		if (done)
			return exitStatus(*done);
		return failed(program, done.error().message, exitCodeOf(done.error().kind));
	}
	catch (const std::bad_alloc&)
	{
		return failed(program, "out of memory; use a smaller input or a machine with more memory", ExitCode::output);
	}
	catch (const std::exception& error)
	{
		return failed(program, error.what(), ExitCode::output);
	}
}

} // namespace

int runProgram(const Program& program, int argc, char** argv)
{
	CLI::App app{program.about, program.name};
	app.set_version_flag("--version", kVersion);
	app.require_subcommand(1);
	app.footer(program.footer);

	fillClosedStreams();
	keepFreedMemory();
	nameThreadRow("main");
	setProgramName(program.name);
	const MessageListener messages(
	    [](Severity, std::string_view line)
	    {
		    if (isFirst())
			    printLine(line);
	    });
	const auto progress = isFirst() ? std::make_unique<ProgressLine>() : nullptr;
	std::signal(SIGINT, endInterrupted);
	std::signal(SIGTERM, endInterrupted);
	Run run;
	for (const auto add : program.commands)
		add(app, run);

	// CLI11 would say that a command is missing, not that this word is not a command.
	std::vector<std::string> commands;
	for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
		commands.push_back(command->get_name());
	const Result<std::vector<std::string>> arguments =
	    withCommand({argv + 1, argv + argc}, commands, program.opens_files);
	if (!arguments)
		return failed(program, fmt::format("{}; see {} --help", arguments.error().message, program.name),
		              ExitCode::usage);
	try
	{
		app.parse(joinNumbers(*arguments));
	}
	catch (const CLI::CallForHelp&)
	{
		if (isFirst())
			print("{}", app.help());
		return told(program);
	}
	catch (const CLI::CallForVersion&)
	{
		if (isFirst())
			print("{} {}\n", program.name, kVersion);
		return told(program);
	}
	catch (const CLI::ParseError& error)
	{
		return failed(program, usageLine(program.name, app, error), ExitCode::usage);
	}
	return carryOut(program, run);
}

} // namespace vp::app
