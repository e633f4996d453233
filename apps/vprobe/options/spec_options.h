#pragma once

#include "base/result.h"
#include "view/view_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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

// Which options of a section a command has.
enum class Scope : std::uint8_t
{
	all,
	flat,  // without those that have no meaning in a flat picture
	no_cut // without those that say how cells are found
};

// Adds the options of a section of the settings: input, probe, look, vectors, contours, sweep or machine. Errors in
// values are kept in `wrong`, because the input may still come from a state.
void addSettings(CLI::App& command, SpecOptions& options, std::string_view section, Scope scope = Scope::all);
void addMemory(CLI::App& command, SpecOptions& options);         // --memory alone, for commands that cut nothing
CLI::Option* addInputs(CLI::App& command, SpecOptions& options); // returns INPUT, which is required
void addTrustOptions(CLI::App& command);                       // what the reader of INPUT may do; addInputs() adds them
void addProbeOptions(CLI::App& command, SpecOptions& options); // the probe, and the machine
void addExplain(CLI::App& command, SpecOptions& options);      // for commands that end with a cut
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
