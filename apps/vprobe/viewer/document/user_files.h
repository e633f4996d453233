#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// Holds the preferences that the window keeps between runs. They are in a folder volume-probes in the XDG base
// directories.

struct Settings
{
	bool dark = true;
	double text_size = 1.0;              // factor on the size that suits the screen, kMinTextSize to kMaxTextSize
	std::optional<std::size_t> hint = 0; // number of the hint to show; empty after the user has dismissed the hints
	std::vector<std::string> recent;     // inputs as absolute paths, the last one first
};

constexpr std::size_t kMaxRecent = 12;
constexpr double kMinTextSize = 0.7;
constexpr double kMaxTextSize = 2.5;
constexpr double kTextStep = 1.1;

// Returns the saved settings, or defaults if there are none or they cannot be read.
Settings readSettings();
// Returns false if the settings cannot be written. The window works without them.
bool writeSettings(const Settings& settings);
void remember(Settings& settings, const std::string& input);

// Returns the name of the file that keeps this process's state until it ends without a fault. Returns an empty name if
// there is no folder for it.
std::string recoveryFile();
// Returns the recovery files of processes that ended by a fault, the newest first.
std::vector<std::string> leftRecoveryFiles();

} // namespace vp::app
