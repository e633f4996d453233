#include "viewer/panels/widgets.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace vp::app
{

namespace
{

using interact::Action;
using interact::Binding;

// Returns the commands that are possible now and have the text in their names, in the order of the menus.
std::vector<const Binding*> matchingCommands(const Document& document, std::string_view wanted)
{
	std::vector<const Binding*> found;
	for (const Binding& binding : interact::bindings())
	{
		const bool is_known = !found.empty() && found.back()->action == binding.action;
		if (!is_known && binding.action != Action::find_command && isPossible(document, binding.action) &&
		    containsText(binding.words, wanted))
			found.push_back(&binding);
	}
	return found;
}

void perform(Desk& desk, Action action)
{
	desk.document.parts.command_search = false;
	desk.document.perform(action);
}

} // namespace

void showCommandSearch(Desk& desk)
{
	static std::array<char, 64> wanted{};
	static int chosen = 0;
	const ImGuiViewport& all = *ImGui::GetMainViewport();
	const auto scale = static_cast<float>(desk.scale);
	ImGui::SetNextWindowPos({all.GetWorkCenter().x, all.WorkPos.y + 40.0f * scale}, ImGuiCond_Always, {0.5f, 0.0f});
	ImGui::SetNextWindowSize({std::min(440.0f * scale, 0.94f * all.WorkSize.x), 0.6f * all.WorkSize.y});
	if (ImGui::Begin("Find a command", &desk.document.parts.command_search,
	                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
	                     ImGuiWindowFlags_NoNav))
	{
		if (ImGui::IsWindowAppearing())
		{
			wanted = {};
			chosen = 0;
			ImGui::SetKeyboardFocusHere();
		}
		ImGui::SetNextItemWidth(-1.0f);
		ImGui::InputTextWithHint("##wanted", "What do you want to do?", wanted.data(), wanted.size());
		if (ImGui::IsItemEdited())
			chosen = 0;
		const std::vector<const Binding*> found = matchingCommands(desk.document, wanted.data());
		const int last = static_cast<int>(found.size()) - 1;
		OpenParts& parts = desk.document.parts;
		chosen = std::clamp(chosen + std::exchange(parts.search_steps, 0), 0, std::max(last, 0));
		ImGui::BeginChild("commands");
		for (int i = 0; i <= last; ++i)
		{
			const Binding& command = *found[static_cast<std::size_t>(i)];
			if (ImGui::Selectable(std::string(command.words).c_str(), i == chosen))
				perform(desk, command.action);
			if (i == chosen)
				ImGui::SetScrollHereY();
			const std::string keys = interact::keysOf(command.action);
			ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(keys.c_str()).x -
			                ImGui::GetStyle().ItemInnerSpacing.x);
			ImGui::TextDisabled("%s", keys.c_str());
		}
		if (found.empty())
			ImGui::TextDisabled("No command has this in its name");
		ImGui::EndChild();
		if (std::exchange(parts.search_enters, false) && !found.empty())
			perform(desk, found[static_cast<std::size_t>(chosen)]->action);
	}
	ImGui::End();
}

} // namespace vp::app
