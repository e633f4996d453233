#include "viewer/panels/widgets.h"

#include <algorithm>

namespace vp::app
{

namespace
{

using interact::Binding;

// Shows all actions of a group, each once, in the order of the list.
void groupItems(Desk& desk, std::string_view group)
{
	std::optional<interact::Action> last;
	for (const Binding& binding : interact::bindings())
	{
		if (binding.group != group || binding.action == last)
			continue;
		last = binding.action;
		actionItem(desk, binding.action);
	}
}

} // namespace

void showMenu(Desk& desk)
{
	if (!ImGui::BeginMainMenuBar())
		return;
	std::string_view last;
	for (const Binding& binding : interact::bindings())
	{
		if (binding.group == last)
			continue;
		last = binding.group;
		if (ImGui::BeginMenu(std::string(last).c_str()))
		{
			groupItems(desk, last);
			ImGui::EndMenu();
		}
	}
	ImGui::EndMainMenuBar();
}

} // namespace vp::app
