#pragma once

#include "base/result.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace vp::app
{

// Adds a line to a file of runs: the times of a profile, when and on which machine they were measured, and a label.
Status appendRun(const std::string& path, const std::string& label, const nlohmann::json& profile);

// One run of a history.
struct HistoryRun
{
	std::string time;                                   // "2026-11-26T14:05:27Z"
	std::string label;                                  // the date, if no label was given
	std::vector<std::pair<std::string, double>> stages; // ms of each, in the order in which they begin
};

// Runs that can be compared: on the same machine and device, of the same work.
struct History
{
	std::string subject{}; // what was measured, and where
	std::vector<HistoryRun> runs{};
	std::size_t others = 0; // runs of other machines or other work, left out
};

// Reads a file of runs, and takes those that are like the last one. An input error names the file and the line.
Result<History> readHistory(const std::string& path);

// Returns the history as a picture, a panel for each stage.
std::string historySvg(const History& history);

} // namespace vp::app
