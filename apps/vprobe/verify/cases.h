#pragma once

#include "base/result.h"
#include "view/view_spec.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// A state with the files beside it that say what is expected.
struct VerifyCase
{
	std::string state;            // the file
	view::ViewSpec spec;          // if it could be read
	std::optional<Error> wrong{}; // why it cannot be judged
	bool has_picture = false;     // NAME.png
	bool has_flat = false;        // NAME.flat.png, or NAME.flat.0.png and so on
	bool has_figures = false;     // NAME.figures.json
	bool has_frames = false;      // NAME.first.png, NAME.middle.png or NAME.last.png

	// Returns the name of a file beside the state, as stem("a/shell.json") + ending.
	std::string beside(const std::string& ending) const;
	std::string picture() const { return beside(".png"); }
	std::string flat() const { return beside(".flat.png"); }
	std::string figures() const { return beside(".figures.json"); }
	bool hasAny() const { return has_picture || has_flat || has_figures || has_frames; }
};

// Finds the cases of the command line: states, and folders of them. `machine` replaces the settings of the machine. A
// case that cannot be judged has its error in it, and so has a folder without states. Cases of one input stand
// together, so that it is read once. may_be_alone: nothing needs to be expected of a state yet.
std::vector<VerifyCase> findCases(const std::vector<std::string>& places, const view::MachineSpec& machine,
                                  bool may_be_alone);

} // namespace vp::app
