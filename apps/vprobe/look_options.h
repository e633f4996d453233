#pragma once

#include "base/result.h"
#include "render/camera.h"
#include "render/look.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// The LOOK options, as they stand on the command line.
struct LookOptions
{
	std::string size = "1280x720";
	int samples = 8;
	std::string colormap = "viridis";
	std::vector<double> range; // none, or LO and HI
	double opacity = 1.0;
	std::string background = "gradient";
	std::string camera = "auto";
	std::string outline = "box";
	std::optional<std::string> title;
};

void addLookOptions(CLI::App& command, LookOptions& options);

Result<render::Look> makeLook(const LookOptions& options);

} // namespace vp::app
