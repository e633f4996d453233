#pragma once

#include "exit_code.h"
#include "render/picture.h"

#include <optional>
#include <string>

namespace vp::app
{

// The picture that --expect names. It is read before any input is.
struct ExpectedPicture
{
	std::string file; // empty if there is nothing to compare with
	render::Picture picture{};
	std::string difference{}; // where to draw the difference; or empty
};

// Reads --expect FILE.png. Returns a usage error for --difference alone.
Result<ExpectedPicture> readExpected(const std::string& file, const std::string& difference);

// Compares a picture that was drawn with so many samples. If it differs, says so on standard error, writes the
// difference, and returns ExitCode::differs.
Result<ExitCode> compareWith(const ExpectedPicture& expected, const render::Picture& drawn, int samples);

// Checks --expect FILE.json before long work. An empty name passes.
Status checkExpected(const std::string& file);

// The same for a --stats document.
Result<ExitCode> compareWith(const std::string& file, const std::string& stats);

} // namespace vp::app
