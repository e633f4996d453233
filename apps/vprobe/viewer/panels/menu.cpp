#include "viewer/panels/widgets.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::app
{

namespace
{

using interact::Binding;

// The groups of actions, from left to right.
std::vector<std::string> menuGroups()
{
	std::vector<std::string> groups;
	for (const Binding& binding : interact::bindings())
		if (groups.empty() || groups.back() != binding.group)
			groups.emplace_back(binding.group);
	return groups;
}

// Shows all actions of a group, each once, in the order of the list. by_keys: the first one that is possible has the
// keyboard.
void groupItems(Desk& desk, std::string_view group, bool by_keys)
{
	std::optional<interact::Action> last;
	for (const Binding& binding : interact::bindings())
	{
		if (binding.group != group || binding.action == last)
			continue;
		last = binding.action;
		actionItem(desk, binding.action);
		if (by_keys && isPossible(desk.document, binding.action))
		{
			focusLastItem();
			by_keys = false;
		}
	}
}

} // namespace

void showMenu(Desk& desk)
{
	if (!ImGui::BeginMainMenuBar())
		return;
	const std::vector<std::string> groups = menuGroups();
	const int count = static_cast<int>(groups.size());
	OpenParts& parts = desk.document.parts;
	std::optional<int> opened;
	if (const std::optional<int> opens = std::exchange(parts.opens_menu, std::nullopt))
	{
		opened = (*opens % count + count) % count;
		ImGui::OpenPopup(groups[*opened].c_str());
	}
	parts.open_menu.reset();
	for (int menu = 0; menu < count; ++menu)
		if (ImGui::BeginMenu(groups[menu].c_str()))
		{
			parts.open_menu = menu;
			groupItems(desk, groups[menu], opened == menu);
			ImGui::EndMenu();
		}
	ImGui::EndMainMenuBar();
}

} // namespace vp::app
