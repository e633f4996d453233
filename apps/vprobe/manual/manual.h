#pragma once

#include "base/result.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace vp::app
{

// Makes the documents of the command line from the options themselves, as --help does.

// The subcommands that a user sees.
std::vector<const CLI::App*> shownCommands(const CLI::App& program);

// Returns a manual page in roff. command: the program itself, or one of its subcommands.
std::string manPage(const CLI::App& program, const CLI::App& command);

// Return a script for bash or zsh that completes subcommands, options, their values, names of arrays, and files.
std::string bashCompletion(const CLI::App& program);
std::string zshCompletion(const CLI::App& program);

} // namespace vp::app
