#include "view/words.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::app
{

namespace
{

using interact::Action;

template <class T>
void showLookChoice(Desk& desk, const char* label, std::span<const Choice> choices, T view::LookSpec::*option,
                    std::string_view words)
{
	showChoice(desk, label, choices, view::text(desk.document.state().look.*option), words,
	           [&](view::ViewSpec& state, const char* word) { state.look.*option = *view::parse<T>(word); });
}

bool isBoundary(const view::ContextSpec& context)
{
	return context.kind == view::ContextKind::boundary;
}

void showBoundary(Desk& desk)
{
	const auto& context = desk.document.state().look.context;
	const auto found = std::ranges::find_if(context, isBoundary);
	const bool on = found != context.end();
	toggle(desk, "Boundary", on, "The domain's boundary around the sheets, as if of glass",
	       [&](view::ViewSpec& state)
	       {
		       if (on)
			       std::erase_if(state.look.context, isBoundary);
		       else
			       state.look.context.push_back(view::contextOf(view::ContextKind::boundary));
	       });
	if (!on)
		return;
	ImGui::SameLine();
	ImGui::SetNextItemWidth(-1.0f);
	auto opacity = static_cast<float>(found->opacity);
	if (ImGui::SliderFloat("##boundary", &opacity, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp))
		desk.document.change(
		    "Boundary's opacity",
		    [&](view::ViewSpec& state)
		    { std::ranges::find_if(state.look.context, isBoundary)->opacity = std::round(100.0 * opacity) / 100.0; },
		    "boundary");
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip("Opacity of the boundary; 1 hides what is behind it");
}

void showTitle(Desk& desk)
{
	const view::LookSpec& look = desk.document.state().look;
	std::string title = look.title.value_or("");
	labeled("Title");
	if (ImGui::InputTextWithHint("##title", look.title ? "none" : "the input's name", &title))
		desk.document.change(
		    "Title", [&](view::ViewSpec& state) { state.look.title = title; }, "title");
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip("Above the picture; empty for none");
}

void showBackground(Desk& desk)
{
	static constexpr std::array kGrounds{Choice{"gradient", "Gradient"}, Choice{"white", "White"},
	                                     Choice{"grey", "Grey"}, Choice{"#20242b", "Dark"}, Choice{"black", "Black"}};
	showChoice(desk, "Background", kGrounds, render::backgroundText(desk.document.state().look.background),
	           "Behind the scene; letters suit it",
	           [&](view::ViewSpec& state, const char* word)
	           { state.look.background = *render::parseBackground(word); });
}

} // namespace

void showSceneSection(Desk& desk)
{
	static constexpr std::array kOutlines{Choice{"box", "Boxes"}, Choice{"edges", "Sharp edges"},
	                                      Choice{"none", "None"}};
	static constexpr std::array kAxes{Choice{"corner", "In the corner"}, Choice{"box", "Numbers on the box"},
	                                  Choice{"none", "None"}};
	showLookChoice(desk, "Outline", kOutlines, &view::LookSpec::outline, tipOf(Action::outline));
	showLookChoice(desk, "Axes", kAxes, &view::LookSpec::axes, tipOf(Action::axes));
	showBackground(desk);
	showBoundary(desk);
	const view::LookSpec& look = desk.document.state().look;
	toggle(desk, "Legend", !look.no_legend, tipOf(Action::legend),
	       [](view::ViewSpec& state) { state.look.no_legend = !state.look.no_legend; });
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	toggle(desk, "Values on lines", !look.no_labels, "Contour lines bear their values",
	       [](view::ViewSpec& state) { state.look.no_labels = !state.look.no_labels; });
	showTitle(desk);
	ImGui::Checkbox("Handles", &desk.document.parts.handles);
	tip(tipOf(Action::handles));
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	ImGui::Checkbox("Dark theme", &desk.document.settings.dark);
	tip(tipOf(Action::dark_theme));
}

} // namespace vp::app
