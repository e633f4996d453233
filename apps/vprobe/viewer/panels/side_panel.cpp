#include "viewer/panels/sections.h"

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

struct Section
{
	const char* name;
	const char* tip;
	void (*show)(Desk& desk);
	ShownWhen when;
	bool unfolded;
};

#define VP_ENTRY(name, tip, show, when, unfolded) Section{name, tip, show, ShownWhen::when, unfolded},
constexpr std::array kSections{VP_SECTIONS(VP_ENTRY)};
#undef VP_ENTRY

bool isShown(const Section& section, const std::optional<DatasetInfo>& data)
{
	switch (section.when)
	{
	case ShownWhen::always:
		return true;
	case ShownWhen::loaded:
		return data.has_value();
	case ShownWhen::times:
		return data && data->times.size() > 1;
	case ShownWhen::vectors:
		return data && std::ranges::any_of(data->arrays, DatasetInfo::isVector);
	}
	return false;
}

// Brings the section of the last heading to the top, and the keyboard to it.
void reachSection(Desk& desk)
{
	desk.document.parts.opens_color_map = false;
	ImGui::SetScrollHereY(0.0f);
	focusLastItem();
}

} // namespace

void showSidePanel(Desk& desk, const ScenePart& room)
{
	static bool had_keys = false;
	const bool has_keys = desk.document.parts.panel_keys;
	if (has_keys && !had_keys)
		ImGui::SetNextWindowFocus();
	beginFixed("side", room, ImGuiWindowFlags_AlwaysVerticalScrollbar, has_keys);
	if (!has_keys && had_keys)
		ImGui::SetWindowFocus(nullptr);
	had_keys = has_keys;
	for (const Section& section : kSections)
	{
		if (!isShown(section, desk.document.facts()))
			continue;
		const bool comes = section.show == showColorMapSection && desk.document.parts.opens_color_map;
		if (comes)
			ImGui::SetNextItemOpen(true);
		const bool open = ImGui::CollapsingHeader(section.name, section.unfolded ? ImGuiTreeNodeFlags_DefaultOpen : 0);
		if (comes)
			reachSection(desk);
		// For keys it would hide what the section shows.
		if (ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()))
			tip(section.tip);
		if (!open)
			continue;
		ImGui::PushID(section.name);
		section.show(desk);
		ImGui::PopID();
		ImGui::Spacing();
	}
	ImGui::End();
}

} // namespace vp::app
