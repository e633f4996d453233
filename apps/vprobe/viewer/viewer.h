#pragma once

#include "base/result.h"
#include "exit_code.h"
#include "viewer/document/document.h"

#include <string>

namespace vp::app
{

struct ViewerOptions
{
	view::ViewSpec state;
	ReadState read_state;
	std::string stats;    // figures of how fast the window was, as JSON, when it closes; empty: none
	std::string commands; // a file of commands that are carried out while it runs; empty: none
};

// Opens the window and stays until it is closed.
Result<ExitCode> runViewer(const ViewerOptions& options);

} // namespace vp::app
