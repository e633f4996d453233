#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// What the window keeps from one day to the next, beside states that the user saves: where the XDG base directories
// say, in a folder volume-probes.

struct Settings
{
	bool dark = true;
	double text_size = 1.0;              // times the size that suits the screen, kMinTextSize to kMaxTextSize
	std::optional<std::size_t> hint = 0; // the one that is shown; none once they have been dismissed
	std::vector<std::string> recent;     // inputs, the last one first; as absolute paths
};

constexpr std::size_t kMaxRecent = 12;
constexpr double kMinTextSize = 0.7;
constexpr double kMaxTextSize = 2.5;
constexpr double kTextStep = 1.1;

// Defaults where there are none, or they cannot be read.
Settings readSettings();
// Where they cannot be kept the window works all the same: false.
bool writeSettings(const Settings& settings);
void remember(Settings& settings, const std::string& input);

// The file that keeps this process's state until it ends well; empty where there is no place for it.
std::string recoveryFile();
// Of processes that are gone and did not end well; the newest first.
std::vector<std::string> leftRecoveryFiles();

} // namespace vp::app
