#pragma once

#include "options/spec_options.h"
#include "probe/path.h"

#include <string>
#include <vector>

namespace vp::app
{

// Holds what the command line of `profile` says.
struct ProfileOptions
{
	SpecOptions common;
	std::string path = "profile"; // not the sweep's that a state brings
	int planes = probe::kProfilePlanes;
	bool draw = false;
	std::string json;
	std::string trace;
	bool no_floor = false;
	std::string append;               // file of runs
	std::string label;                // names this run there
	std::string history;              // file of runs to draw
	std::string output;               // picture of them
	std::vector<std::string> compare; // none, or two files

	// Measuring in turns.
	std::vector<std::string> versus;         // each: options of another setting
	std::vector<std::string> versus_program; // each: another build
	int rounds = 60;                         // at most
	std::vector<std::string> at_most;        // each: [STAGE=]RATIO

	// A program that measures in turns asks the others for this.
	std::string with;        // options that take precedence over all others
	bool turns_pipe = false; // answer on a pipe, plane by plane

	bool inTurns() const { return !versus.empty() || !versus_program.empty(); }
};

// Takes the options in a text, as a shell would split it, on top of the others. An error says what is wrong in the
// text, but does not name the option that gave it.
Status takeOptions(ProfileOptions& options, const std::string& text);

} // namespace vp::app
