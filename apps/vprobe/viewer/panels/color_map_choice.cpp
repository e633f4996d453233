#include "viewer/panels/color_maps.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::app
{

namespace
{

// Returns a file's name without its folder.
std::string shortName(const std::string& word)
{
	return word.find(".json") == std::string::npos ? word : std::filesystem::path(word).filename().string();
}

void previewLastItem(const std::string& word, float from)
{
	const render::ColorMap* map = colorMapOf(word);
	if (!map)
		return;
	const ImVec2 lo = ImGui::GetItemRectMin();
	const ImVec2 hi = ImGui::GetItemRectMax();
	const float inset = 0.2f * (hi.y - lo.y);
	drawGradient(*ImGui::GetWindowDrawList(), *map, {lo.x + from * (hi.x - lo.x), lo.y + inset},
	             {hi.x - inset, hi.y - inset});
}

void chooseMap(Desk& desk, const std::string& word)
{
	desk.document.change(fmt::format("Color map {}", shortName(word)),
	                     [&](view::ViewSpec& state) { state.look.colormap = word; });
}

void item(Desk& desk, const std::string& word, const std::string& now)
{
	if (ImGui::Selectable(fmt::format("{}##map", shortName(word)).c_str(), word == now, 0,
	                      {0.0f, ImGui::GetFrameHeight()}))
		chooseMap(desk, word);
	previewLastItem(word, 0.45f);
}

} // namespace

void showColorMapChoice(Desk& desk)
{
	const std::string now = desk.document.colorMapName();
	labeled("Map");
	const ImVec2 at = ImGui::GetCursorScreenPos();
	const float width = ImGui::CalcItemWidth();
	const float height = ImGui::GetFrameHeight();
	ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
	if (ImGui::BeginCombo("##map", "", ImGuiComboFlags_HeightLarge))
	{
		for (const std::string& name : render::colorMapNames())
			item(desk, isReversed(now) ? otherWay(name) : name, now);
		if (now.find(".json") != std::string::npos)
			item(desk, now, now);
		ImGui::EndCombo();
	}
	ImGui::PopStyleVar();
	tip(fmt::format("Color map: {}. A ParaView preset comes from a file with --colormap FILE.json", shortName(now)));
	const float inset = 0.22f * height;
	if (const render::ColorMap* map = colorMapOf(now))
		drawGradient(*ImGui::GetWindowDrawList(), *map, {at.x + inset, at.y + inset},
		             {at.x + width - height - inset, at.y + height - inset});
	bool reversed = isReversed(now);
	if (ImGui::Checkbox("Reversed", &reversed))
		chooseMap(desk, otherWay(now));
	tip("The colors of high and low values change places");
}

} // namespace vp::app
