#include "viewer/panels/setting_search.h"

#include "view/settings.h"
#include "viewer/panels/widgets.h"

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

std::string optionName(std::string_view key)
{
	std::string name(key);
	std::ranges::replace(name, '_', '-');
	return name;
}

// The window has a size of its own, and no flat pictures. What opens data or a device is said before.
bool isOfWindow(std::string_view section, const view::Setting& setting)
{
	const std::string_view key = setting.key;
	return key != "size" && setting.offer != view::Offer::flat && (section != "input" || key == "time");
}

FoundSetting found(const view::Setting& setting)
{
	FoundSetting made{setting.key, optionName(setting.key), setting.values, setting.help};
	if (const bool* const* value = std::get_if<bool*>(&setting.place))
	{
		made.is_switch = true;
		made.is_on = **value;
	}
	if (const auto* text = std::get_if<view::Text>(&setting.place); text && made.values.empty())
		for (const std::string& word : text->words)
			made.values += (made.values.empty() ? "" : "|") + word;
	return made;
}

} // namespace

std::vector<FoundSetting> matchingSettings(const Document& document, std::string_view wanted)
{
	std::vector<FoundSetting> settings;
	// The places of the list are read only.
	for (const view::Section& section : view::sectionsOf(const_cast<view::ViewSpec&>(document.state())))
		for (const view::Setting& setting : section.settings)
			if (isOfWindow(section.key, setting) && containsText(optionName(setting.key), wanted))
				settings.push_back(found(setting));
	return settings;
}

std::optional<SettingOrder> settingOrder(const Document& document, std::string_view text)
{
	constexpr std::string_view kBlank = " ";
	const auto trimmed = [&](std::string_view part)
	{
		const std::size_t begin = std::min(part.find_first_not_of(kBlank), part.size());
		part.remove_prefix(begin);
		return part.substr(0, part.find_last_not_of(kBlank) + 1);
	};
	text = trimmed(text);
	if (text.starts_with("--"))
		text.remove_prefix(2);
	const std::size_t end = std::min(text.find_first_of(" ="), text.size());
	const std::string option = optionName(text.substr(0, end));
	const std::string value(trimmed(text.substr(std::min(end + 1, text.size()))));
	for (const FoundSetting& setting : matchingSettings(document, option))
	{
		if (setting.option != option)
			continue;
		if (setting.is_switch && value.empty())
			return SettingOrder{setting, setting.is_on ? "false" : "true"};
		if (setting.is_switch && (value == "on" || value == "off"))
			return SettingOrder{setting, value == "on" ? "true" : "false"};
		if (!value.empty())
			return SettingOrder{setting, value};
	}
	return std::nullopt;
}

} // namespace vp::app
