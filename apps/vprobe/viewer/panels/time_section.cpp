#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr const char* kMerge = "time";

void playTimes(Document& document)
{
	if (!document.state().sweep.over_times)
		document.change("Path through time",
		                [](view::ViewSpec& state)
		                {
			                state.sweep.over_times = true;
			                state.sweep.own.reset();
			                state.sweep.frames.reset();
		                });
	document.perform(Action::play);
}

} // namespace

void showTimeSection(Desk& desk)
{
	Document& document = desk.document;
	const auto& times = document.facts()->times;
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	int step = document.timeStep();
	const std::string words =
	    fmt::format("t = {:.6g}   ({} of {})", times[static_cast<std::size_t>(step)], step + 1, times.size());
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::SliderInt("##time", &step, 0, static_cast<int>(times.size()) - 1, words.c_str(),
	                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
		document.showTime(step, kMerge);
	if (ImGui::IsItemDeactivated())
		document.endMerge();
	tip("The time that is shown");
	actionButton(desk, Action::previous_time, "Earlier", shareOfLine(3));
	ImGui::SameLine(0.0f, gap);
	const bool plays = document.playback().isPlaying() && document.state().sweep.over_times;
	if (ImGui::Button(plays ? "Pause##play" : "Play##play", {shareOfLine(2), 0.0f}))
		playTimes(document);
	tip("Shows one time after the other: the sweep's path leads through time");
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::next_time, "Later", shareOfLine(1));
}

void showCameraSection(Desk& desk)
{
	struct View
	{
		Action action;
		const char* name;
	};
	static constexpr std::array kViews{View{Action::view_x, "x"},    View{Action::view_minus_x, "-x"},
	                                   View{Action::view_y, "y"},    View{Action::view_minus_y, "-y"},
	                                   View{Action::view_z, "z"},    View{Action::view_minus_z, "-z"},
	                                   View{Action::view_iso, "xyz"}};
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	ImGui::TextDisabled("View from");
	int left = kViews.size();
	for (const View& view : kViews)
	{
		actionButton(desk, view.action, view.name, shareOfLine(left));
		if (--left > 0)
			ImGui::SameLine(0.0f, gap);
	}
	actionButton(desk, Action::reset_camera, "Fit", shareOfLine(2));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::face_sheet, "Face the sheet", shareOfLine(1));
}

} // namespace vp::app
