#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr int kMaxLines = 40; // maximum of the slider

std::string titleOf(const DatasetInfo::Array& array)
{
	return fmt::format("{}  ({})", array.name, array.association == grid::Association::cell ? "cells" : "points");
}

void chooseArray(Desk& desk, const DatasetInfo::Array& array)
{
	desk.document.change(fmt::format("Array {}", array.name),
	                     [&](view::ViewSpec& state)
	                     {
		                     state.probe.array = array.word;
		                     state.probe.component.reset();
		                     state.look.color_by = view::ColorBy::array;
		                     state.look.range.reset();
	                     });
}

void showArrays(Desk& desk, const DatasetInfo::Array* now)
{
	const bool by_generation = desk.document.state().look.color_by == view::ColorBy::generation;
	const std::string shown = by_generation ? "Generation" : now ? titleOf(*now) : "None";
	labeled("Array");
	if (ImGui::BeginCombo("##array", shown.c_str(), ImGuiComboFlags_HeightLarge))
	{
		for (const DatasetInfo::Array& array : desk.document.facts()->arrays)
			if (ImGui::Selectable(titleOf(array).c_str(), !by_generation && &array == now))
				chooseArray(desk, array);
		if (ImGui::Selectable("Generation", by_generation))
			desk.document.change("Colors by generation",
			                     [](view::ViewSpec& state)
			                     {
				                     state.look.color_by = view::ColorBy::generation;
				                     state.look.range.reset();
				                     state.look.logarithmic = false;
			                     });
		tip("When the traversal met each cell, from the seeds on");
		ImGui::EndCombo();
	}
	tip(fmt::format("What the sheets show: {}\n{}\n{}", shown, tipOf(Action::next_array),
	                tipOf(Action::previous_array)));
}

void showComponents(Desk& desk, const DatasetInfo::Array* now)
{
	if (!now || now->components < 2 || desk.document.state().look.color_by == view::ColorBy::generation)
		return;
	const int chosen = desk.document.state().probe.component.value_or(grid::kMagnitude);
	labeled("Component");
	if (ImGui::BeginCombo("##component", grid::componentName(chosen, now->components).c_str()))
	{
		for (int component = grid::kMagnitude; component < now->components; ++component)
		{
			const std::string each = grid::componentName(component, now->components);
			if (ImGui::Selectable(each.c_str(), component == chosen))
				desk.document.change(fmt::format("Component {}", each),
				                     [&](view::ViewSpec& state)
				                     {
					                     state.probe.component = component;
					                     state.look.range.reset();
				                     });
		}
		ImGui::EndCombo();
	}
	tip("Of an array of vectors or tensors: its length, or one of its numbers");
}

void showSheetOpacity(Desk& desk)
{
	showSlider(desk, {.label = "Opacity"}, "opacity");
}

void showLineCount(Desk& desk, Action action, const char* label, int view::LookSpec::*option)
{
	int count = desk.document.state().look.*option;
	labeled(label);
	if (ImGui::SliderInt(fmt::format("##{}", label).c_str(), &count, 0, kMaxLines, count == 0 ? "none" : "about %d"))
		desk.document.change(
		    label, [&](view::ViewSpec& state) { state.look.*option = std::max(0, count); }, label);
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip(tipOf(action));
}

} // namespace

void showColorSection(Desk& desk)
{
	const DatasetInfo::Array* now = desk.document.shownArray();
	showArrays(desk, now);
	showComponents(desk, now);
	showColorMapChoice(desk);
	showRangeChoice(desk);
	showSheetOpacity(desk);
	showLineCount(desk, Action::lines, "Lines", &view::LookSpec::lines);
	showLineCount(desk, Action::bands, "Bands", &view::LookSpec::bands);
	const view::LookSpec& look = desk.document.state().look;
	toggle(desk, "Cell edges", look.mesh, tipOf(Action::mesh),
	       [](view::ViewSpec& state) { state.look.mesh = !state.look.mesh; });
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	toggle(desk, "Lit", "lit");
}

} // namespace vp::app
