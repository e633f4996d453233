#include "viewer/panels/sections.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::app
{

namespace
{

enum class Ends
{
	data,
	slice,
	fixed
};
constexpr std::array kEnds{"Whole data", "This slice", "Fixed"};
constexpr std::array kEndsTips{
    "The colors' ends are the lowest and highest value of the whole array; of a scan, its window",
    "Those of what the sheets show, at every moment",
    "Two numbers of yours; values beyond them have the colors of the ends"};

Ends endsOf(const view::LookSpec& look)
{
	return look.range ? Ends::fixed : look.range_of == view::RangeOf::slice ? Ends::slice : Ends::data;
}

// Returns the ends of the picture's color range.
std::array<double, 2> shownEnds(const Document& document)
{
	const view::LookSpec& look = document.state().look;
	if (look.range)
		return {look.range->first, look.range->second};
	if (!document.shown() || !document.shown()->values)
		return {0.0, 1.0};
	const render::ValueScale& values = *document.shown()->values;
	return {look.logarithmic ? values.log_lo : values.lo, values.hi};
}

void chooseEnds(Desk& desk, Ends ends)
{
	const std::array<double, 2> shown = shownEnds(desk.document);
	desk.document.change(
	    "Range of the colors",
	    [&](view::ViewSpec& state)
	    {
		    view::LookSpec& look = state.look;
		    look.range.reset();
		    look.range_of = ends == Ends::slice ? view::RangeOf::slice : view::RangeOf::automatic;
		    if (ends != Ends::fixed)
			    return;
		    const bool spans = shown[0] < shown[1];
		    look.range = std::pair{shown[0], spans ? shown[1] : shown[0] + std::max(1.0, std::abs(shown[0]))};
		    look.symmetric = false;
	    });
}

void showEnds(Desk& desk)
{
	std::array<double, 2> ends = shownEnds(desk.document);
	const bool fixed = endsOf(desk.document.state().look) == Ends::fixed;
	ImGui::BeginDisabled(!fixed);
	ImGui::SetNextItemWidth(-1.0f);
	const double speed = std::max(1e-300, 0.004 * std::abs(ends[1] - ends[0]));
	const bool changed = dragNumbers(desk, {"##ends", speed}, ends.data(), 2,
	                                 fixed ? "Values at the low and the high end of the color map"
	                                       : "Values at the ends of the color map; choose Fixed to set them");
	ImGui::EndDisabled();
	if (!fixed || !changed || !(ends[0] < ends[1]) || (desk.document.state().look.logarithmic && ends[0] <= 0.0))
		return;
	desk.document.change(
	    "Range of the colors",
	    [&](view::ViewSpec& state) {
		    state.look.range = std::pair{ends[0], ends[1]};
	    },
	    "range");
}

void showScaling(Desk& desk)
{
	const view::LookSpec& look = desk.document.state().look;
	ImGui::BeginDisabled(look.logarithmic || look.range);
	toggle(desk, "Symmetric about 0", "symmetric");
	ImGui::EndDisabled();
	toggle(desk, "Logarithmic", look.logarithmic,
	       "Colors follow the values' logarithm; values of 0 and below have none",
	       [](view::ViewSpec& state)
	       {
		       view::LookSpec& next = state.look;
		       next.logarithmic = !next.logarithmic;
		       if (!next.logarithmic)
			       return;
		       next.symmetric = false;
		       if (next.range && next.range->first <= 0.0)
			       next.range.reset();
	       });
}

} // namespace

void showRangeChoice(Desk& desk)
{
	const Ends now = endsOf(desk.document.state().look);
	labeled("Range");
	if (ImGui::BeginCombo("##range", kEnds[static_cast<std::size_t>(now)]))
	{
		for (const Ends ends : {Ends::data, Ends::slice, Ends::fixed})
		{
			const auto index = static_cast<std::size_t>(ends);
			if (ImGui::Selectable(kEnds[index], ends == now))
				chooseEnds(desk, ends);
			tip(kEndsTips[index]);
		}
		ImGui::EndCombo();
	}
	tip(tipOf(interact::Action::range_of_slice));
	showEnds(desk);
	showScaling(desk);
}

} // namespace vp::app
