#pragma once

#include "base/result.h"
#include "exit_code.h"
#include "viewer/document/read_state.h"

#include <string>

namespace vp::app
{

struct ViewerOptions
{
	view::ViewSpec state;
	ReadState read_state;
	std::string stats;    // file for figures of the window's speed, written as JSON when it closes; empty: none
	std::string commands; // file of commands that the window carries out; empty: none
	std::string trace;    // file of all sections of work, for chrome://tracing; empty: none
};

// Opens the window and stays until it is closed.
Result<ExitCode> runViewer(const ViewerOptions& options);

} // namespace vp::app
