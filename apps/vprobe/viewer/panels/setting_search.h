#pragma once

#include "viewer/panels/panels.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::app
{

// A setting that Ctrl+K offers. Its names are those of the options: "range" or "--range", "no-legend" or "no_legend".
struct FoundSetting
{
	std::string key;
	std::string option; // without the dashes before it
	std::string values; // the form of its values
	std::string help;
	bool is_switch = false; // true or false; without a value it is turned over
	bool is_on = false;
};

// Returns the settings that can be set in a window and have the text in their names.
std::vector<FoundSetting> matchingSettings(const Document& document, std::string_view wanted);

// A setting and a value for it.
struct SettingOrder
{
	FoundSetting setting;
	std::string value;
};

// Reads a text such as "range 0 5", or "mesh" for a switch.
std::optional<SettingOrder> settingOrder(const Document& document, std::string_view text);

} // namespace vp::app
