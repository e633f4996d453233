#include "view/sections.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr double kBoundaryOpacity = 0.15; // where none is given, see docs/LOOKS.md

void showLookChoice(Desk& desk, const char* label, std::span<const Choice> choices, std::string LookOptions::*option,
                    std::string_view words)
{
	showChoice(desk, label, choices, desk.bench.state().look.*option, words,
	           [&](ViewState& state, const char* word) { state.look.*option = word; });
}

bool isBoundary(const std::string& context)
{
	return context == "boundary" || context.starts_with("boundary:");
}

double opacityOf(const std::string& context)
{
	double opacity = kBoundaryOpacity;
	const std::size_t colon = context.find(':');
	if (colon != std::string::npos)
		std::from_chars(context.data() + colon + 1, context.data() + context.size(), opacity);
	return opacity;
}

void showBoundary(Desk& desk)
{
	const auto& context = desk.bench.state().look.context;
	const auto found = std::ranges::find_if(context, isBoundary);
	const bool on = found != context.end();
	toggle(desk, "Boundary", on, "The domain's boundary around the sheets, as if of glass",
	       [&](ViewState& state)
	       {
		       if (on)
			       std::erase_if(state.look.context, isBoundary);
		       else
			       state.look.context.push_back("boundary");
	       });
	if (!on)
		return;
	ImGui::SameLine();
	ImGui::SetNextItemWidth(-1.0f);
	auto opacity = static_cast<float>(opacityOf(*found));
	if (ImGui::SliderFloat("##boundary", &opacity, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp))
		desk.bench.change(
		    "Boundary's opacity",
		    [&](ViewState& state)
		    { *std::ranges::find_if(state.look.context, isBoundary) = fmt::format("boundary:{:.2f}", opacity); },
		    "boundary");
	if (ImGui::IsItemDeactivated())
		desk.bench.endMerge();
	tip("Opacity of the boundary; 1 hides what is behind it");
}

void showTitle(Desk& desk)
{
	const LookOptions& look = desk.bench.state().look;
	std::string title = look.title.value_or("");
	labeled("Title");
	if (ImGui::InputTextWithHint("##title", look.title ? "none" : "the input's name", &title))
		desk.bench.change(
		    "Title", [&](ViewState& state) { state.look.title = title; }, "title");
	if (ImGui::IsItemDeactivated())
		desk.bench.endMerge();
	tip("Above the picture; empty for none");
}

void showBackground(Desk& desk)
{
	static constexpr std::array kGrounds{Choice{"gradient", "Gradient"}, Choice{"white", "White"},
	                                     Choice{"grey", "Grey"}, Choice{"#20242b", "Dark"}, Choice{"black", "Black"}};
	showLookChoice(desk, "Background", kGrounds, &LookOptions::background, "Behind the scene; letters suit it");
}

} // namespace

void showSceneSection(Desk& desk)
{
	static constexpr std::array kOutlines{Choice{"box", "Boxes"}, Choice{"edges", "Sharp edges"},
	                                      Choice{"none", "None"}};
	static constexpr std::array kAxes{Choice{"corner", "In the corner"}, Choice{"box", "Numbers on the box"},
	                                  Choice{"none", "None"}};
	showLookChoice(desk, "Outline", kOutlines, &LookOptions::outline, tipOf(Action::outline));
	showLookChoice(desk, "Axes", kAxes, &LookOptions::axes, tipOf(Action::axes));
	showBackground(desk);
	showBoundary(desk);
	const LookOptions& look = desk.bench.state().look;
	toggle(desk, "Legend", !look.no_legend, tipOf(Action::legend),
	       [](ViewState& state) { state.look.no_legend = !state.look.no_legend; });
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	toggle(desk, "Values on lines", !look.no_labels, "Contour lines bear their values",
	       [](ViewState& state) { state.look.no_labels = !state.look.no_labels; });
	showTitle(desk);
	ImGui::Checkbox("Handles", &desk.bench.parts.handles);
	tip(tipOf(Action::handles));
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	ImGui::Checkbox("Dark theme", &desk.bench.settings.dark);
	tip(tipOf(Action::dark_theme));
}

} // namespace vp::app
