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

// What a command line says about what is cut and how it looks: the options that every command that cuts has.
struct SpecOptions
{
	view::ViewSpec spec;
	std::string save;             // where the settings are kept
	bool explain = false;         // the plan is wanted in place of the cut
	std::optional<Error> wrong{}; // the first that could not be read: a value, the file of a probe, of a path, a state
};

// Each adds a group of options to a command. Errors of values are kept in `wrong`, since a command may name its input
// in a state.
CLI::Option* addInputs(CLI::App& command, SpecOptions& options);
void addProbeOptions(CLI::App& command, SpecOptions& options); // with the machine's
void addMachineOptions(CLI::App& command, SpecOptions& options);
void addExplain(CLI::App& command, SpecOptions& options); // of commands that end with a cut
enum class LookScope
{
	space, // pictures in space: all options
	plane  // flat pictures of sheets: those that mean something there
};
void addLookOptions(CLI::App& command, SpecOptions& options, LookScope scope = LookScope::space);
void addVectorOptions(CLI::App& command, SpecOptions& options, LookScope scope = LookScope::space);
void addContourOptions(CLI::App& command, SpecOptions& options);
void addPathOptions(CLI::App& command, SpecOptions& options);
// --save and --state. What stands on the command line beside --state goes before what the file says, whatever the
// order.
void addStateOptions(CLI::App& command, SpecOptions& options);

// Reads the file of a path, or takes the name of a built-in one.
Status choosePath(view::SweepSpec& sweep, const std::string& name);

// Of options that have no say where no picture is drawn: an error names the first that the command line has, why there
// is none ("-o a.vtp is none") and what would draw one.
Status refuseLook(const CLI::App& command, const std::string& why, const char* remedy);

// First of all: tells what is wrong and what is missing.
Status prepare(const SpecOptions& options);

// Writes the --save file, if one is asked for.
Status saveSpec(const SpecOptions& options);

} // namespace vp::app
