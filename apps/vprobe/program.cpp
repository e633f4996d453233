#include "program.h"

#include "base/kept_memory.h"
#include "base/timeline.h"
#include "interrupt.h"
#include "last_word.h"
#include "options/arguments.h"
#include "options/first_word.h"
#include "parts/source.h"
#include "read/sandbox.h"
#include "report/console.h"
#include "report/progress_line.h"
#include "team.h"
#include "version.h"
#include "write/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
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
	if (code == ExitCode::interrupted && signalThatCame() != 0)
		return statusOfSignal(signalThatCame());
	return static_cast<int>(code);
}

// A request to end leaves no half-written file. As in a shell, the exit status names the signal.
void endInterrupted(int signal)
{
	if (deferInterrupt(signal))
		return;
	write::removeUnfinishedFiles();
	_exit(statusOfSignal(signal));
}

// SIGHUP or SIGQUIT that was ignored at the start stays so: nohup has a program go on when its terminal goes.
void endOnSignals()
{
	for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
	{
		struct sigaction before = {};
		sigaction(signal, nullptr, &before);
		if (before.sa_handler != SIG_IGN || signal == SIGINT || signal == SIGTERM)
			std::signal(signal, endInterrupted);
	}
}

// Returns CLI11's reason as one line that names the remedy.
std::string usageLine(std::string_view name, const CLI::App& program, const CLI::ParseError& error)
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

int failedForMemory(const Program& program)
{
	try
	{
		return failed(program, std::string(kOutOfMemory), ExitCode::output);
	}
	catch (const std::bad_alloc&)
	{
		sayOutOfMemory(); // there is none even for the line
		return exitStatus(ExitCode::output);
	}
}

// Ends the program after a help text. Returns the exit status.
int told(const Program& program)
{
	const Status written = flushOutput();
	return written ? exitStatus(ExitCode::done) : failed(program, written.error().message, ExitCode::output);
}

std::string sandboxOfReader()
{
	const Result<std::string> held = read::tryOutSandbox();
	return held ? *held : fmt::format("not known ({})", held.error().message);
}

// Adds the command that the arguments begin with. All are added if there is none, and for the manual, which tells of
// all; that takes milliseconds.
void addCommands(const Program& program, const std::vector<std::string>& arguments, CLI::App& app, Run& run)
{
	const std::string_view asked = arguments.empty() ? std::string_view() : arguments.front();
	const bool is_command = asked != "manual" && std::ranges::any_of(program.commands, [&](const Command& command)
	                                                                 { return command.name == asked; });
	for (const Command& command : program.commands)
		if (!is_command || command.name == asked)
			command.add(app, run);
}

// Commands whose result a script may rely on.
void addStrict(CLI::App& app, bool& is_strict)
{
	constexpr std::array kCommands{"slice", "render", "sweep", "sample", "convert", "pack", "verify"};
	for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
		if (std::ranges::find(kCommands, command->get_name()) != kCommands.end())
			command->add_flag("--strict", is_strict,
			                  "Fail with exit code 6 if there was a warning, such as an empty slice");
}

// Counts what is said to the user.
struct Said
{
	std::atomic<int> warnings = 0;
	bool is_strict = false; // warnings are failures
};

int carryOut(const Program& program, const Run& run, const Said& said)
{
	try
	{
		Result<ExitCode> done = run();
		if (Status written = flushOutput(); done && !written)
			done = written.error();
		if (done && *done == ExitCode::done && said.is_strict && said.warnings > 0)
			return failed(program, "--strict: there were warnings", ExitCode::differs);
		if (done)
			return exitStatus(*done);
		return failed(program, done.error().message, exitCodeOf(done.error().kind));
	}
	catch (const std::bad_alloc&)
	{
		throw; // runProgram() says so
	}
	catch (const parts::Unreadable& error)
	{
		return failed(program, error.what(), exitCodeOf(ErrorKind::input));
	}
	catch (const std::exception& error)
	{
		return failed(program, error.what(), ExitCode::output);
	}
}

int runCommand(const Program& program, int argc, char** argv)
{
	if (program.hand_over && argc > 1) // before any work that the other program would do again
		program.hand_over(argv[0], {argv + 1, argv + argc});
	sayLastWord(program.name);
	CLI::App app{std::string(program.about), std::string(program.name)};
	app.set_version_flag("--version", kVersion);
	app.require_subcommand(1);
	app.footer(std::string(program.footer));

	fillClosedStreams();
	keepFreedMemory();
	nameThreadRow("main");
	setProgramName(std::string(program.name));
	Said said;
	const MessageListener messages(
	    [&said](Severity severity, std::string_view line)
	    {
		    said.warnings += severity == Severity::warning;
		    if (isFirst())
			    printLine(severity == Severity::warning ? fmt::format("warning: {}", line) : std::string(line));
	    });
	const auto progress = isFirst() ? std::make_unique<ProgressLine>() : nullptr;
	endOnSignals();
	std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large shows as an error of the write
	// CLI11 would say that a command is missing, not that this word is not a command.
	std::vector<std::string> commands;
	for (const Command& command : program.commands)
		commands.emplace_back(command.name);
	const Result<std::vector<std::string>> arguments =
	    withCommand({argv + 1, argv + argc}, commands, program.opens_files);
	if (!arguments)
		return failed(program, fmt::format("{}; see {} --help", arguments.error().message, program.name),
		              ExitCode::usage);
	if (program.hand_over && !arguments->empty() && argc > 1 && arguments->front() != argv[1])
		program.hand_over(argv[0], *arguments); // for a command that was not written
	setCommandLine(*arguments);
	Run run;
	addCommands(program, *arguments, app, run);
	addStrict(app, said.is_strict);
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
			print("{} {}\nsandbox: {}\n", program.name, kVersion, sandboxOfReader());
		return told(program);
	}
	catch (const CLI::ParseError& error)
	{
		return failed(program, usageLine(program.name, app, error), ExitCode::usage);
	}
	return carryOut(program, run, said);
}

} // namespace

int runProgram(const Program& program, int argc, char** argv)
{
	try
	{
		return runCommand(program, argc, argv);
	}
	catch (const std::bad_alloc&)
	{
		return failedForMemory(program);
	}
}

} // namespace vp::app
