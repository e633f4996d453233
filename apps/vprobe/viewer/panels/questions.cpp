#include "read/formats.h"
#include "read/read.h"
#include "viewer/panels/file_browser.h"
#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

namespace vp::app
{

namespace
{

// A question for a file: its texts, and which files it takes.
struct FileQuestion
{
	Question question;
	const char* title;
	const char* button;
	const char* endings; // endings with blanks between; null: those of all inputs
	const char* name;    // suggested file name
	const char* words;   // what its answer does
};

constexpr std::array kFileQuestions{
    FileQuestion{Question::open, "Open", "Open", nullptr, "", "Data, or a state that was saved (.json)"},
    FileQuestion{Question::save_state, "Save the state", "Save", ".json", "state.json",
                 "All that is set: vprobe view, render and sweep bring it back"},
    FileQuestion{Question::save_picture, "Save the picture", "Save", ".png", "picture.png",
                 "The scene, without handles and panels"},
    FileQuestion{Question::save_film, "Save the film", "Save", ".mp4 .mkv .webm .png", "film.mp4",
                 "The film loop that was recorded; a .png with {frame} in its name is a picture a frame"},
    FileQuestion{Question::save_slice, "Export the slice", "Export", ".vtp .vtm .ply .csv", "slice.vtp",
                 "Polygons with all arrays: .vtp, .vtm (a file a sheet), .ply, or .csv as a table"},
    FileQuestion{Question::save_color_map, "Save the color map", "Save", ".json", "colormap.json",
                 "The map and its opacities: --colormap FILE.json takes them, and so does ParaView"},
    FileQuestion{Question::save_trace, "Write a trace", "Write", ".json", "trace.json",
                 "Where the time of the last minute went, for ui.perfetto.dev or chrome://tracing"},
};

// The answer so far to the current question. The user interface has one question at a time.
struct Answer
{
	Question question = Question::none;
	FileBrowser browser;
	bool overwrites = false; // asks now whether to overwrite the file
	int size[2] = {1280, 720};
	std::filesystem::path folder = std::filesystem::current_path();
};

Answer& answer()
{
	static Answer now;
	return now;
}

std::vector<std::string> words(const std::string& text)
{
	std::istringstream stream(text);
	return {std::istream_iterator<std::string>(stream), {}};
}

void begin(const FileQuestion& asked, const Document& document)
{
	Answer& now = answer();
	now.overwrites = false;
	std::vector<std::string> endings = words(asked.endings ? asked.endings : read::readableEndings() + " .json");
	std::string name = asked.name;
	if (asked.question == Question::save_state && !document.stateFile().empty())
		name = std::filesystem::path(document.stateFile()).filename().string();
	if (document.shown())
	{
		now.size[0] = static_cast<int>(document.shown()->image->extent().width);
		now.size[1] = static_cast<int>(document.shown()->image->extent().height);
	}
	now.browser.begin(now.folder, std::move(endings), std::move(name));
}

void take(Desk& desk, const FileQuestion& asked)
{
	Answer& now = answer();
	Document& document = desk.document;
	const std::string file = now.browser.path();
	now.folder = now.browser.folder();
	switch (asked.question)
	{
	case Question::open:
		document.open({file});
		break;
	case Question::save_state:
		document.saveState(file);
		break;
	case Question::save_picture:
		document.savePicture(file, static_cast<std::uint32_t>(now.size[0]), static_cast<std::uint32_t>(now.size[1]));
		break;
	case Question::save_film:
		document.playback().saveFilm(file);
		break;
	case Question::save_color_map:
		document.saveColorMap(file);
		break;
	case Question::save_trace:
		document.saveTrace(file);
		break;
	default:
		document.saveSlice(file);
	}
	document.question = Question::none;
}

void showRecent(Desk& desk)
{
	const std::vector<std::string> recent = desk.document.settings.recent; // a copy: opening one changes them
	if (recent.empty())
		return;
	ImGui::SetNextItemWidth(-1.0f);
	if (!ImGui::BeginCombo("##recent", "Recent files", ImGuiComboFlags_HeightLarge))
		return;
	for (const std::string& input : recent)
		if (ImGui::Selectable(input.c_str()))
		{
			desk.document.open({input});
			desk.document.question = Question::none;
		}
	ImGui::EndCombo();
}

void showPictureSize()
{
	Answer& now = answer();
	ImGui::AlignTextToFramePadding();
	ImGui::TextUnformatted("Size");
	ImGui::SameLine();
	ImGui::SetNextItemWidth(9.0f * ImGui::GetFontSize());
	if (ImGui::InputInt2("##size", now.size))
		for (int& side : now.size)
			side = std::clamp(side, 1, static_cast<int>(render::kMaxPictureSize));
	tip("Width and height in pixels");
}

void showOverwrite(Desk& desk, const FileQuestion& asked)
{
	Answer& now = answer();
	ImGui::AlignTextToFramePadding();
	ImGui::Text("%s is there already.", std::filesystem::path(now.browser.path()).filename().c_str());
	ImGui::SameLine();
	if (ImGui::Button("Overwrite"))
		take(desk, asked);
	ImGui::SameLine();
	if (ImGui::Button("Keep it"))
		now.overwrites = false;
}

void showAnswers(Desk& desk, const FileQuestion& asked, bool chosen)
{
	Answer& now = answer();
	const bool opens = asked.question == Question::open;
	if (now.overwrites && now.browser.exists())
		return showOverwrite(desk, asked);
	ImGui::BeginDisabled(now.browser.path().empty() || (opens && !now.browser.exists()));
	const bool pressed = ImGui::Button(asked.button);
	ImGui::EndDisabled();
	ImGui::SameLine();
	if (ImGui::Button("Cancel"))
		desk.document.question = Question::none;
	else if ((pressed || chosen) && !now.browser.path().empty())
	{
		now.overwrites = !opens && now.browser.exists();
		if (!now.overwrites)
			take(desk, asked);
	}
}

void showFileQuestion(Desk& desk, const FileQuestion& asked)
{
	if (asked.question == Question::open)
		showRecent(desk);
	const float line = ImGui::GetFrameHeightWithSpacing();
	const bool sized = asked.question == Question::save_picture;
	const float below = (sized ? 4.6f : 3.6f) * line;
	const bool chosen = answer().browser.show(std::max(3.0f * line, ImGui::GetContentRegionAvail().y - line - below));
	if (sized)
		showPictureSize();
	ImGui::TextDisabled("%s", asked.words);
	showAnswers(desk, asked, chosen);
}

void showRecovery(Desk& desk)
{
	ImGui::TextWrapped("A window that ended unexpectedly has left what was set in it.");
	ImGui::Spacing();
	if (ImGui::Button("Bring it back"))
		desk.document.recover(true);
	ImGui::SameLine();
	if (ImGui::Button("Forget it"))
		desk.document.recover(false);
}

} // namespace

void showQuestions(Desk& desk)
{
	const Question now = desk.document.question;
	const auto asked = std::ranges::find(kFileQuestions, now, &FileQuestion::question);
	const bool files = asked != kFileQuestions.end();
	const std::string title = fmt::format("{}###question", files ? asked->title : "Volume Probes");
	if (answer().question != now)
	{
		answer().question = now;
		if (files)
			begin(*asked, desk.document);
	}
	if (now != Question::none && !ImGui::IsPopupOpen("###question"))
		ImGui::OpenPopup("###question");
	const ImGuiViewport& all = *ImGui::GetMainViewport();
	const auto scale = static_cast<float>(desk.scale);
	ImGui::SetNextWindowPos(all.GetWorkCenter(), ImGuiCond_Always, {0.5f, 0.5f});
	ImGui::SetNextWindowSize({std::min((files ? 620.0f : 360.0f) * scale, 0.94f * all.WorkSize.x),
	                          files ? std::min(480.0f * scale, 0.9f * all.WorkSize.y) : 0.0f});
	if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
	                            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse))
		return;
	if (files)
		showFileQuestion(desk, *asked);
	else if (now == Question::recover)
		showRecovery(desk);
	if (desk.document.question == Question::none)
		ImGui::CloseCurrentPopup();
	ImGui::EndPopup();
}

} // namespace vp::app
