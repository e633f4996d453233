#include "interact/player.h"
#include "view/settings.h"
#include "viewer/panels/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

struct PathName
{
	const char* word;
	const char* name;
	const char* words;
};
constexpr std::array kPaths{
    PathName{"translate", "Along the normal", "Across the grid, from one side to the other"},
    PathName{"rotate", "About the up axis", "A whole turn"},
    PathName{"spin", "About the normal", "A whole turn"},
    PathName{"revolve", "From vane to vane", "About the up axis, until each vane stands where the next one was"},
    PathName{"profile", "Tilting", "Planes of many slopes through the middle of the grid"},
    PathName{"times", "Through time", "The probe stands still, and the input's times go by"},
};
constexpr int kMaxFrames = 1000; // maximum by dragging; the user can type more

void showPath(Desk& desk)
{
	const view::SweepSpec& options = desk.document.state().sweep;
	const std::string word = view::pathKindText(options);
	const auto now = std::ranges::find_if(kPaths, [&](const PathName& path) { return path.word == word; });
	labeled("Path");
	if (ImGui::BeginCombo("##path", options.own || now == kPaths.end() ? "Of your own" : now->name))
	{
		const bool has_times = desk.document.facts()->times.size() > 1;
		for (const PathName& path : kPaths)
		{
			if (std::string_view(path.word) == "times" && !has_times)
				continue;
			if (ImGui::Selectable(path.name, !options.own && path.word == word))
				desk.document.change(fmt::format("Path {}", path.name), [&](view::ViewSpec& state)
				                     { static_cast<void>(view::setPathKind(state.sweep, path.word)); });
			tip(path.words);
		}
		ImGui::EndCombo();
	}
	tip("Where the probe goes when it is played; key frames of your own come from a file with --path FILE.json");
}

void showFrameCount(Desk& desk)
{
	const view::SweepSpec& options = desk.document.state().sweep;
	if (options.over_times)
		return;
	int frames = options.frames.value_or(desk.document.playback().frames());
	labeled("Frames");
	if (ImGui::DragInt("##frames", &frames, 0.5f, 1, kMaxFrames))
		desk.document.change(
		    "Frames", [&](view::ViewSpec& state) { state.sweep.frames = std::clamp(frames, 1, probe::kMaxFrames); },
		    "frames");
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip("How many pictures the sweep has. Drag, or click and type");
}

void showSpeed(Desk& desk)
{
	double speed = view::framesPerSecond(desk.document.state().sweep);
	labeled("Speed");
	if (dragNumbers(desk,
	                {.id = "##speed",
	                 .speed = 0.1,
	                 .least = interact::kMinSpeed,
	                 .most = interact::kMaxSpeed,
	                 .format = "%.3g a second",
	                 .logarithmic = true},
	                &speed, 1, "Frames a second; what cannot be drawn in time is left out"))
		desk.document.change(
		    "Speed", [&](view::ViewSpec& state) { state.sweep.frames_per_second = speed; }, "speed");
}

void showPlayer(Desk& desk)
{
	Document& document = desk.document;
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	int frame = document.playback().frame();
	ImGui::SetNextItemWidth(-1.0f);
	if (ImGui::SliderInt("##frame", &frame, 0, std::max(0, document.playback().frames() - 1),
	                     fmt::format("{} of {}", frame + 1, document.playback().frames()).c_str(),
	                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
		document.playback().seek(frame);
	if (ImGui::IsItemDeactivated())
		document.endMerge();
	tip("The sweep's frame");
	actionButton(desk, Action::previous_frame, "Back", shareOfLine(3));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::play, document.playback().isPlaying() ? "Pause" : "Play", shareOfLine(2));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::next_frame, "On", shareOfLine(1));
}

void showFilm(Desk& desk)
{
	Document& document = desk.document;
	const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
	if (const auto& recording = document.playback().recording())
	{
		const int done = recording->film->recorded();
		const int all = recording->film->frames();
		ImGui::ProgressBar(static_cast<float>(done) / static_cast<float>(all), {-1.0f, 0.0f},
		                   fmt::format("{} of {}", done, all).c_str());
		tip("Frames that are recorded");
	}
	actionButton(desk, Action::record, document.playback().recording() ? "Cancel" : "Record", shareOfLine(2));
	ImGui::SameLine(0.0f, gap);
	actionButton(desk, Action::save_film, "Save film\u2026", shareOfLine(1));
	ImGui::BeginDisabled(!document.playback().hasExposure());
	ImGui::Checkbox("All frames in one picture", &document.parts.exposure);
	ImGui::EndDisabled();
	tip("As the eye keeps them: their light is added up. Record the sweep first");
}

} // namespace

void showSweepSection(Desk& desk)
{
	showPath(desk);
	showFrameCount(desk);
	showSpeed(desk);
	toggle(desk, "There and back", desk.document.state().sweep.there_and_back, tipOf(Action::there_and_back),
	       [](view::ViewSpec& state) { state.sweep.there_and_back = !state.sweep.there_and_back; });
	ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().ItemSpacing.x);
	bool loops = desk.document.playback().loops();
	if (ImGui::Checkbox("Loop", &loops))
		desk.document.perform(Action::loop);
	tip(tipOf(Action::loop));
	showPlayer(desk);
	showFilm(desk);
}

} // namespace vp::app
