#include "view/panels.h"

#include <fmt/format.h>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus;

void item(Desk& desk, Action action, bool chosen = false, bool enabled = true)
{
	if (ImGui::MenuItem(std::string(interact::wordsOf(action)).c_str(), interact::keysOf(action).c_str(), chosen,
	                    enabled))
		desk.bench.perform(action);
}

void beginFixed(const char* name, const ScenePart& room)
{
	ImGui::SetNextWindowPos({static_cast<float>(room.lo.x), static_cast<float>(room.lo.y)});
	ImGui::SetNextWindowSize({static_cast<float>(room.size.x), static_cast<float>(room.size.y)});
	ImGui::Begin(name, nullptr, kFixed);
}

} // namespace

void showMenu(Desk& desk)
{
	if (!ImGui::BeginMainMenuBar())
		return;
	if (ImGui::BeginMenu("File"))
	{
		item(desk, Action::open);
		item(desk, Action::save_state);
		item(desk, Action::save_picture);
		item(desk, Action::quit);
		ImGui::EndMenu();
	}
	if (ImGui::BeginMenu("Edit"))
	{
		item(desk, Action::undo, false, desk.bench.history().canUndo());
		item(desk, Action::redo, false, desk.bench.history().canRedo());
		ImGui::EndMenu();
	}
	ImGui::EndMainMenuBar();
}

void showSidePanel(Desk& desk, const ScenePart& room)
{
	beginFixed("side", room);
	for (const Action action :
	     {Action::preset_single, Action::preset_trihedral, Action::preset_paddlewheel, Action::preset_stack})
		if (ImGui::Button(std::string(interact::wordsOf(action)).c_str()))
			desk.bench.perform(action);
	ImGui::End();
}

void showStatusLine(Desk& desk, const ScenePart& room)
{
	beginFixed("status", room);
	const Meter& meter = desk.meter;
	ImGui::TextUnformatted(fmt::format("cut {:.1f} ms  draw {:.1f} ms  input to picture {:.0f} ms", meter.cuts().last(),
	                                   meter.draws().last(), meter.answers().last())
	                           .c_str());
	ImGui::End();
}

void showNotices(Desk&, const ScenePart&) {}
void showProfile(Desk&, const ScenePart&) {}
void showHelp(Desk&) {}
void showQuestions(Desk&) {}

} // namespace vp::app
