#include "view/words.h"
#include "viewer/panels/cut_figures.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr float kMaxRows = 6.0f; // rows of sheets; the list scrolls to more
constexpr std::array kPresets{Action::preset_single, Action::preset_trihedral, Action::preset_paddlewheel,
                              Action::preset_stack};
constexpr std::array kPresetNames{"Single", "Trihedral", "Paddlewheel", "Stack"};

void showPresets(Desk& desk)
{
	const auto chosen = std::ranges::find_if(kPresets, [&](Action action) { return isOn(desk.document, action); });
	const bool own = chosen == kPresets.end();
	labeled("Preset");
	if (ImGui::BeginCombo("##preset", own ? "Of your own" : kPresetNames[chosen - kPresets.begin()]))
	{
		for (std::size_t i = 0; i < kPresets.size(); ++i)
		{
			if (ImGui::Selectable(kPresetNames[i], isOn(desk.document, kPresets[i])))
				desk.document.perform(kPresets[i]);
			tip(tipOf(kPresets[i]));
		}
		ImGui::EndCombo();
	}
	tip("Sheets that move as one. Moving one of them alone, sizing its window or hiding it makes the probe one of your "
	    "own");
}

void showSheetCount(Desk& desk, const char* label, int now, int least, int most, std::string_view words,
                    std::optional<int> view::ProbeSpec::*option)
{
	labeled(label);
	if (ImGui::SliderInt("##count", &now, least, most, "%d", ImGuiSliderFlags_AlwaysClamp))
		desk.document.change(
		    label, [&](view::ViewSpec& state) { state.probe.*option = now; }, label);
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip(words);
}

void showCounts(Desk& desk)
{
	constexpr int kMax = 16; // as many sheets as a picture shows
	const view::ProbeSpec& options = desk.document.state().probe;
	if (isOn(desk.document, Action::preset_paddlewheel))
		showSheetCount(desk, "Vanes", options.vanes.value_or(3), 1, kMax, "How many sheets turn about the axis",
		               &view::ProbeSpec::vanes);
	if (isOn(desk.document, Action::preset_stack) && options.offsets.empty())
		showSheetCount(desk, "Sheets", options.sheets.value_or(5), 1, kMax, "How many sheets lie in the stack",
		               &view::ProbeSpec::sheets);
}

// Shows an eye, open or closed. Returns true if it was clicked.
bool eyeButton(const char* id, bool open)
{
	const float height = ImGui::GetFrameHeight();
	const ImVec2 at = ImGui::GetCursorScreenPos();
	const bool clicked = ImGui::InvisibleButton(id, {height, height});
	const float half = 0.30f * height;
	const ImVec2 middle{at.x + 0.5f * height, at.y + 0.5f * height};
	const ImU32 color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark
	                                       : open                 ? ImGuiCol_Text
	                                                              : ImGuiCol_TextDisabled);
	const float thick = 0.07f * height;
	ImDrawList& list = *ImGui::GetWindowDrawList();
	const ImVec2 left{middle.x - half, middle.y};
	const ImVec2 right{middle.x + half, middle.y};
	if (open)
		list.AddBezierQuadratic(left, {middle.x, middle.y - 1.3f * half}, right, color, thick);
	list.AddBezierQuadratic(left, {middle.x, middle.y + 1.3f * half}, right, color, thick);
	if (open)
		list.AddCircleFilled(middle, 0.36f * half, color);
	return clicked;
}

std::string nameOf(const Document& document, const probe::Probe& probe, std::size_t sheet)
{
	const auto& array = probe.sheets[sheet].wishes.array;
	const auto& shown = document.shown();
	std::string name = fmt::format("Sheet {}", sheet + 1);
	if (array)
		name += fmt::format("  {}", *array);
	// The picture has figures only for the sheets that it shows.
	std::size_t visible = 0;
	for (std::size_t i = 0; i < sheet; ++i)
		visible += !probe.sheets[i].wishes.hidden;
	if (!probe.sheets[sheet].wishes.hidden && shown && visible < shown->cut->sheets.size())
		name += fmt::format("   {} cells", grouped(figuresOf(*shown->cut, visible).cut_cells));
	return name;
}

void showSheet(Desk& desk, const probe::Probe& probe, std::size_t sheet)
{
	ImGui::PushID(static_cast<int>(sheet));
	const bool hidden = probe.sheets[sheet].wishes.hidden;
	if (eyeButton("eye", !hidden))
	{
		desk.document.chooseSheet(sheet);
		desk.document.perform(Action::hide_sheet);
	}
	tip(hidden ? "Shows the sheet" : "Hides the sheet: it is neither cut nor drawn");
	ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
	ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(hidden ? ImGuiCol_TextDisabled : ImGuiCol_Text));
	ImVec4 chosen = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
	chosen.w = 0.35f;
	ImGui::PushStyleColor(ImGuiCol_Header, chosen);
	ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
	const std::string name = fmt::format("{}##sheet", nameOf(desk.document, probe, sheet));
	if (ImGui::Selectable(name.c_str(), desk.document.sheet() == sheet, 0, {0.0f, ImGui::GetFrameHeight()}))
		desk.document.chooseSheet(sheet);
	ImGui::PopStyleVar();
	ImGui::PopStyleColor(2);
	tip(fmt::format("Chooses the sheet that keys and fields mean ({})", interact::keysOf(Action::next_sheet)));
	ImGui::PopID();
}

void showSheets(Desk& desk)
{
	const probe::Probe probe = desk.document.probe();
	const ImGuiStyle& style = ImGui::GetStyle();
	const auto rows = static_cast<float>(probe.sheets.size());
	const float height = std::min(rows, kMaxRows) * (ImGui::GetFrameHeight() + style.ItemSpacing.y);
	if (probe.sheets.size() > 1)
	{
		ImGui::BeginChild("sheets", {0.0f, height}, false, ImGuiWindowFlags_NoNav);
		for (std::size_t sheet = 0; sheet < probe.sheets.size(); ++sheet)
			showSheet(desk, probe, sheet);
		ImGui::EndChild();
	}
	actionButton(desk, Action::add_sheet, "Add sheet", shareOfLine(3));
	ImGui::SameLine(0.0f, style.ItemInnerSpacing.x);
	ImGui::BeginDisabled(probe.sheets.size() < 2);
	actionButton(desk, Action::remove_sheet, "Remove", shareOfLine(2));
	ImGui::SameLine(0.0f, style.ItemInnerSpacing.x);
	actionButton(desk, Action::show_all_sheets, "Show all", shareOfLine(1));
	ImGui::EndDisabled();
}

void showSurface(Desk& desk)
{
	std::string text = view::surfaceText(desk.document.state().probe.surface);
	labeled("Surface");
	if (ImGui::InputTextWithHint("##surface", "planes", &text, ImGuiInputTextFlags_EnterReturnsTrue))
		desk.document.setSurface(text);
	tip("What sheets cut by: nothing for planes, sphere:R, cylinder:R, cone:DEGREES, iso:VALUE, or an expression in "
	    "x, y and z. Enter takes it");
}

} // namespace

void showProbeSection(Desk& desk)
{
	showPresets(desk);
	showSurface(desk);
	if (view::replacesSheets(desk.document.state().probe.surface))
		return ImGui::TextWrapped("A part of the grid is shown, which has no sheets to move.");
	showCounts(desk);
	showSheets(desk);
	showPlaceFields(desk);
}

} // namespace vp::app
