#pragma once

#include "commands/commands.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::app
{

// A subcommand, and the function that adds it to a program.
struct Command
{
	std::string_view name;
	void (*add)(CLI::App& program, Run& run);
};

// A program of subcommands. It holds literals alone: main() asks for no memory, since nobody is there yet to say that
// it ran out.
struct Program
{
	std::string_view name;
	std::string_view about;
	std::string_view footer;
	std::span<const Command> commands;
	// Reports why the program ends: a line, and its exit code.
	void (*fail)(const std::string& line, ExitCode code);
	bool opens_files = false; // an input without a command is viewed, or rendered
	// Goes on as another program if that one has the command, which is the first of the arguments; returns if not.
	// called: the name by which this program was called. It may be null.
	void (*hand_over)(const char* called, const std::vector<std::string>& arguments) = nullptr;
};

// Reads the command line and runs the subcommand that it names. Returns the exit status.
int runProgram(const Program& program, int argc, char** argv);

} // namespace vp::app
