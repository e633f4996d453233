#pragma once

#include "commands/commands.h"

#include <string>
#include <vector>

namespace vp::app
{

// A program of subcommands.
struct Program
{
	std::string name;
	std::string about;
	std::string footer;
	std::vector<void (*)(CLI::App& program, Run& run)> commands;
	// Reports why the program ends: a line, and its exit code.
	void (*fail)(const std::string& line, ExitCode code);
	bool opens_files = false; // an input without a command is viewed, or rendered
};

// Reads the command line and runs the subcommand that it names. Returns the exit status.
int runProgram(const Program& program, int argc, char** argv);

} // namespace vp::app
