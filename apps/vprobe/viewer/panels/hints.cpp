#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <array>

namespace vp::app
{

namespace
{

constexpr std::array<const char*, kHints> kHintWords{
    "Drag the sheet. It moves along its normal, and the cut follows.",
    "Drag an arrow to move the probe, or a ring to turn it. The handles come when the pointer is near the sheet.",
    "Drag beside the sheet to turn the view. The wheel with Ctrl zooms to the pointer.",
    "Press Space: the probe sweeps through the data. Ctrl+Z takes any change back.",
    "F1 lists all keys. Ctrl+K finds any command by its name.",
};

} // namespace

void showHints(Desk& desk, const ScenePart& part)
{
	std::optional<std::size_t>& hint = desk.document.settings.hint;
	if (!hint || !desk.document.view())
		return;
	const std::size_t now = std::min(*hint, kHints - 1);
	const auto width = static_cast<float>(std::min(400.0 * desk.scale, 0.9 * part.size.x));
	ImGui::SetNextWindowPos(
	    {static_cast<float>(part.lo.x + 0.5 * part.size.x), static_cast<float>(part.lo.y + 12.0 * desk.scale)},
	    ImGuiCond_Always, {0.5f, 0.0f});
	ImGui::SetNextWindowSize({width, 0.0f});
	ImGui::PushStyleColor(ImGuiCol_WindowBg, theme(desk.document.settings.dark).note);
	ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().FrameRounding);
	ImGui::Begin("hint", nullptr,
	             ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
	                 ImGuiWindowFlags_NoFocusOnAppearing);
	ImGui::PushTextWrapPos();
	ImGui::TextUnformatted(kHintWords[now]);
	ImGui::PopTextWrapPos();
	ImGui::AlignTextToFramePadding();
	ImGui::TextDisabled("%s", fmt::format("{} of {}", now + 1, kHints).c_str());
	const bool is_last = now + 1 == kHints;
	const char* next = is_last ? "Done" : "Next";
	const ImGuiStyle& style = ImGui::GetStyle();
	const auto widthOf = [&](const char* label) { return ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x; };
	const char* skip = "No hints";
	ImGui::SameLine(width - style.WindowPadding.x - widthOf(next) - style.ItemSpacing.x - widthOf(skip));
	if (ImGui::Button(skip))
		hint.reset();
	tip("They come back by the menu: Window, Hints for the first steps");
	ImGui::SameLine();
	if (ImGui::Button(next))
		hint = is_last ? std::nullopt : std::optional(now + 1);
	tip(is_last ? "Takes the hints away" : "The next hint");
	ImGui::End();
	ImGui::PopStyleVar();
	ImGui::PopStyleColor();
}

} // namespace vp::app
