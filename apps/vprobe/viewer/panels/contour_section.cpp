#include "viewer/panels/pointer_words.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

void showFollowing(Desk& desk)
{
	bool follows = desk.document.parts.contour;
	if (ImGui::Checkbox("Follows the pointer", &follows))
		desk.document.perform(interact::Action::contour);
	tip(tipOf(interact::Action::contour));
	const std::optional<session::PointedValue> pointed = desk.document.pointedContour();
	if (!pointed)
		return;
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	if (ImGui::Button(fmt::format("Keep {:.5g}", pointed->value).c_str()))
		desk.document.change("Keep the contour",
		                     [&](view::ViewSpec& state) { state.look.contour.values.push_back(pointed->value); });
	tip("It stays, as a contour of every sheet, and is saved with the state");
}

// Shows a button for each kept contour. The button takes the contour away.
void showKept(Desk& desk)
{
	const view::ContourSpec& contour = desk.document.state().look.contour;
	for (std::size_t i = 0; i < contour.values.size(); ++i)
	{
		ImGui::PushID(static_cast<int>(i));
		const bool gone = ImGui::Button(fmt::format("{:.5g}", contour.values[i]).c_str());
		tip("Takes this contour away");
		ImGui::PopID();
		if (gone)
			return desk.document.change("Take a contour away",
			                            [&](view::ViewSpec& state)
			                            {
				                            auto& values = state.look.contour.values;
				                            values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
			                            });
		if (i % 4 != 3 && i + 1 < contour.values.size())
			ImGui::SameLine();
	}
}

void showContourOpacity(Desk& desk)
{
	auto opacity = static_cast<float>(desk.document.state().look.contour.opacity);
	labeled("Opacity");
	if (ImGui::SliderFloat("##opacity", &opacity, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp))
		desk.document.change(
		    "Opacity of contours", [&](view::ViewSpec& state) { state.look.contour.opacity = opacity; },
		    "contour opacity");
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip("Of contours; 1 hides what is behind them");
}

void showDepth(Desk& desk)
{
	auto depth = static_cast<float>(desk.document.state().look.contour.depth);
	const auto most = static_cast<float>(desk.document.facts()->bounds.diagonal());
	labeled("Depth");
	if (ImGui::SliderFloat("##depth", &depth, 0.0f, most, depth == 0.0f ? "as the window" : "%.4g",
	                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic))
		desk.document.change(
		    "Depth of contours", [&](view::ViewSpec& state) { state.look.contour.depth = depth; }, "contour depth");
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip("Of the box about a sheet that they are grown in; 0 follows the window's smaller side");
}

} // namespace

void showContourSection(Desk& desk)
{
	showFollowing(desk);
	showKept(desk);
	showDepth(desk);
	showContourOpacity(desk);
}

// If the pointer leaves the sheets, the last value stays, so that the user sees what the panel changes.
void followPointer(Desk& desk)
{
	if (!desk.document.parts.contour)
		return;
	if (const auto pointed = pointedAt(desk))
		if (const auto value = valueOf(desk, *pointed))
			desk.document.pointContour(value);
}

} // namespace vp::app
