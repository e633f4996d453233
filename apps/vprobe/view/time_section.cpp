#include "view/sections.h"

#include <fmt/format.h>

#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr const char* kMerge = "time";

} // namespace

void playTimes(Desk& desk)
{
	Workbench& bench = desk.bench;
	if (!bench.parts.plays_times || !bench.facts() || !bench.isShown())
		return;
	const auto steps = static_cast<int>(bench.facts()->times.size());
	if (steps < 2)
		bench.parts.plays_times = false;
	else
		bench.showTime((bench.timeStep() + 1) % steps, kMerge);
}

void showTimeSection(Desk& desk)
{
	Workbench& bench = desk.bench;
	const auto& times = bench.facts()->times;
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	int step = bench.timeStep();
	const std::string words =
	    fmt::format("t = {:.6g}   ({} of {})", times[static_cast<std::size_t>(step)], step + 1, times.size());
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::SliderInt("##time", &step, 0, static_cast<int>(times.size()) - 1, words.c_str(),
	                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
	{
		bench.parts.plays_times = false;
		bench.showTime(step, kMerge);
	}
	if (ImGui::IsItemDeactivated())
		bench.endMerge();
	tip("The time that is shown");
	actionButton(desk, Action::previous_time, "Earlier", shareOfLine(3));
	ImGui::SameLine(0.0f, gap);
	if (ImGui::Button(bench.parts.plays_times ? "Pause##play" : "Play##play", {shareOfLine(2), 0.0f}))
	{
		bench.parts.plays_times = !bench.parts.plays_times;
		bench.endMerge();
	}
	tip("Shows one time after the other, as fast as they can be read, and begins again");
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
