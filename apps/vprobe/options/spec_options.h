#pragma once

#include "base/result.h"
#include "view/view_spec.h"

#include <optional>
#include <string>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace vp::app
{

// Holds what the command line says about the cut and its look: the options that all commands that cut have in common.
struct SpecOptions
{
	view::ViewSpec spec;
	std::string save;             // file for the settings; empty for none
	bool explain = false;         // print the plan and cut nothing
	std::optional<Error> wrong{}; // the first error in a value, a probe file, a path file or a state
};

// Each function adds a group of options to a command. Errors in values are kept in `wrong`, because the input may still
// come from a state.
CLI::Option* addInputs(CLI::App& command, SpecOptions& options);
void addProbeOptions(CLI::App& command, SpecOptions& options); // adds the options of the machine too
void addMachineOptions(CLI::App& command, SpecOptions& options);
void addExplain(CLI::App& command, SpecOptions& options); // for commands that end with a cut
enum class LookScope
{
	space, // pictures in space take all options
	plane  // flat pictures take only the options that have a meaning there
};
void addLookOptions(CLI::App& command, SpecOptions& options, LookScope scope = LookScope::space);
void addVectorOptions(CLI::App& command, SpecOptions& options, LookScope scope = LookScope::space);
void addContourOptions(CLI::App& command, SpecOptions& options);
void addPathOptions(CLI::App& command, SpecOptions& options);
// Adds --save and --state. Options on the command line take precedence over the state file, in whatever order they
// stand.
void addStateOptions(CLI::App& command, SpecOptions& options);

// Takes the name of a built-in path, or reads a path file.
Status choosePath(view::SweepSpec& sweep, const std::string& name);

// Returns an error if the command line has a look option although no picture is drawn. The error names the option, the
// reason ("-o a.vtp is none"), and what would draw a picture.
Status refuseLook(const CLI::App& command, const std::string& why, const char* remedy);

// Call this first: it returns the first error in the options, and says if the input is missing.
Status prepare(const SpecOptions& options);

// Writes the --save file if the option was given.
Status saveSpec(const SpecOptions& options);

} // namespace vp::app
