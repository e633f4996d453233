#include "grid/demo/demo.h"
#include "viewer/panels/demo_pictures.h"
#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace vp::app
{

namespace
{

constexpr std::size_t kMaxShown = 6; // number of recent files
constexpr std::size_t kCardsALine = 3;

void showHeading(const char* words)
{
	ImGui::Dummy({0.0f, 0.5f * ImGui::GetFontSize()});
	ImGui::TextDisabled("%s", words);
}

void showRecentFiles(Desk& desk)
{
	const std::vector<std::string> recent = desk.document.settings.recent; // a copy: opening one changes them
	if (recent.empty())
		return;
	showHeading("Recent files");
	for (std::size_t i = 0; i < std::min(recent.size(), kMaxShown); ++i)
	{
		const std::string name = std::filesystem::path(recent[i]).filename().string();
		if (ImGui::Selectable(fmt::format("{}##{}", name, i).c_str()))
			desk.document.open({recent[i]});
		tip(recent[i]);
	}
}

// Returns the picture of a demo. It is made when the page first shows it, only one per frame, so that the window stays
// responsive.
const DemoPicture* pictureOf(const std::string& name)
{
	static std::map<std::string, DemoPicture> made;
	static int frame = -1;
	if (const auto known = made.find(name); known != made.end())
		return &known->second;
	if (ImGui::GetFrameCount() == frame)
		return nullptr;
	frame = ImGui::GetFrameCount();
	return &(made[name] = makeDemoPicture(name));
}

void showDemo(Desk& desk, const grid::Demo& demo, const ImVec2& size)
{
	const std::string name = demo.name;
	const ImVec2 lo = ImGui::GetCursorScreenPos();
	if (ImGui::Button(("##" + name).c_str(), size))
		desk.document.open({"demo:" + name});
	tip(fmt::format("demo:{}: {}", name, demo.about));
	ImDrawList& list = *ImGui::GetWindowDrawList();
	const float line = ImGui::GetTextLineHeightWithSpacing();
	const float margin = 0.3f * line;
	if (const DemoPicture* picture = pictureOf(name))
		picture->draw(list, {lo.x, lo.y + margin}, {size.x, size.y - line - 2.0f * margin});
	const ImVec2 text = ImGui::CalcTextSize(name.c_str());
	list.AddText({lo.x + 0.5f * (size.x - text.x), lo.y + size.y - line}, ImGui::GetColorU32(ImGuiCol_Text),
	             name.c_str());
}

void showDemos(Desk& desk)
{
	showHeading("Built-in data sets");
	const float width = shareOfLine(static_cast<int>(kCardsALine));
	const ImVec2 size{width, width};
	std::size_t i = 0;
	for (const grid::Demo& demo : grid::demos())
	{
		if (i++ % kCardsALine)
			ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
		showDemo(desk, demo, size);
	}
}

} // namespace

void showStartPage(Desk& desk, const ScenePart& part)
{
	const auto width = static_cast<float>(std::min(440.0 * desk.scale, 0.94 * part.size.x));
	ImGui::SetNextWindowPos(
	    {static_cast<float>(part.lo.x + 0.5 * part.size.x), static_cast<float>(part.lo.y + 0.5 * part.size.y)},
	    ImGuiCond_Always, {0.5f, 0.5f});
	ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, static_cast<float>(0.96 * part.size.y)});
	ImGui::Begin("start", nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoBackground |
	                 ImGuiWindowFlags_NoBringToFrontOnFocus);
	ImGui::SetWindowFontScale(1.6f);
	ImGui::TextUnformatted("Volume Probes");
	ImGui::SetWindowFontScale(1.0f);
	actionButton(desk, interact::Action::open, "Open a file\u2026");
	ImGui::SameLine();
	ImGui::TextDisabled("or drop one here");
	showRecentFiles(desk);
	showDemos(desk);
	ImGui::End();
}

} // namespace vp::app
