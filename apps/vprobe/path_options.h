#pragma once

#include "base/result.h"
#include "probe/path.h"

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace vp::app
{

// How a probe is swept, as it stands on the command line.
struct PathOptions
{
	std::string path = "translate"; // or another name, or a .json file; empty: own_path
	std::optional<probe::Path> own_path{};
	std::optional<int> frames{};
	double per_second = 25.0;
	bool there_and_back = false;

	// The probe stands still, and the input's times go by.
	bool overTimes() const { return path == "times" && !own_path; }

	bool operator==(const PathOptions&) const = default;
};

void addPathOptions(CLI::App& command, PathOptions& options);

// Reads the path's file, where one is named, into own_path.
Status readPathFile(PathOptions& options);

// The path, its file read.
probe::Path pathOf(const PathOptions& options);

// How many frames the options or the path say; a usage error where neither does. 0 over the input's times.
Result<int> frameCount(const PathOptions& options, const probe::Path& path);

} // namespace vp::app
