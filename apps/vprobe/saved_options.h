#pragma once

#include "look_options.h"
#include "path_options.h"
#include "probe_options.h"

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace vp::app
{

// What --save keeps and --state brings back, for every command that cuts: a state saved by one serves the others.
struct SavedOptions
{
	ProbeOptions probe;
	LookOptions look;
	PathOptions path;
	std::string save;
	std::optional<Error> state_error{}; // why the --state file cannot be used
};

// --save and --state. What stands on the command line beside --state goes before what the file says, whatever the
// order.
void addStateOptions(CLI::App& command, SavedOptions& options);

// Pictures show planes only; a usage error, before any input is read, where the options ask for another mesh.
Status requirePlanes(const SavedOptions& options);

// Takes a --state file's settings over. command: any that has a --state.
Status loadState(const CLI::App& command, SavedOptions& options, const std::string& file);

// First of all: tells what is wrong with --state and what is missing, and reads the files of probe and path.
Status prepare(SavedOptions& options);

// Writes the --save file, if one is asked for.
Status saveState(const SavedOptions& options);

} // namespace vp::app
