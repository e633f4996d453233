#include "viewer/sections.h"

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

struct Section
{
	const char* name;
	const char* words;
	void (*show)(Desk& desk);
	bool unfolded;
};

constexpr std::array kSections{
    Section{"Data", "What is loaded", showDataSection, true},
    Section{"Probe", "The sheets, where they stand, their windows", showProbeSection, true},
    Section{"Colours", "What array the sheets show, and how", showColorSection, true},
    Section{"Vectors", "Arrows, and paths of particles, launched from the sheets", showVectorSection, false},
    Section{"Contours", "Surfaces of one value, grown from the sheets", showContourSection, false},
    Section{"Time", "The input's time steps", showTimeSection, true},
    Section{"Sweep", "The probe moved along a path, as a film", showSweepSection, false},
    Section{"Magnifier", "What a sheet shows, magnified", showMagnifierSection, false},
    Section{"Scene", "What is drawn around the sheets", showSceneSection, false},
    Section{"Camera", "Where the scene is seen from", showCameraSection, false},
};

bool isOfUse(const Section& section, const Document& bench)
{
	if (section.show == showDataSection)
		return true;
	if (section.show == showTimeSection)
		return bench.facts() && bench.facts()->times.size() > 1;
	if (section.show == showVectorSection)
		return bench.facts() && std::ranges::any_of(bench.facts()->arrays, DatasetInfo::isVector);
	return bench.facts().has_value();
}

} // namespace

void showSidePanel(Desk& desk, const ScenePart& room)
{
	beginFixed("side", room, ImGuiWindowFlags_AlwaysVerticalScrollbar);
	for (const Section& section : kSections)
	{
		if (!isOfUse(section, desk.bench))
			continue;
		const bool open = ImGui::CollapsingHeader(section.name, section.unfolded ? ImGuiTreeNodeFlags_DefaultOpen : 0);
		tip(section.words);
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
