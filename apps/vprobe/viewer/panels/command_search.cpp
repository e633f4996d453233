#include "viewer/panels/setting_search.h"
#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace vp::app
{

namespace
{

using interact::Action;
using interact::Binding;

// The search as it stands. There is one.
struct Search
{
	std::array<char, 256> wanted{};
	int chosen = 0;
	std::string completion; // takes the place of what was typed
	std::string complaint;  // why a setting could not be set
};

Search& search()
{
	static Search now;
	return now;
}

// A line of the list: a command, or a setting with or without a value for it.
struct Found
{
	const Binding* command = nullptr;
	std::optional<SettingOrder> order;
	std::optional<FoundSetting> setting;
};

// Returns what is possible now and has the text in its name: a setting with its value, commands in the order of the
// menus, and settings that want a value.
std::vector<Found> found(const Document& document, std::string_view wanted)
{
	std::vector<Found> all;
	if (std::optional<SettingOrder> order = settingOrder(document, wanted))
		all.push_back({nullptr, std::move(order), {}});
	const Binding* last = nullptr;
	for (const Binding& binding : interact::bindings())
	{
		const bool is_known = last && last->action == binding.action;
		if (!is_known && binding.action != Action::find_command && isPossible(document, binding.action) &&
		    containsText(binding.words, wanted))
			all.push_back({last = &binding, {}, {}});
	}
	if (!wanted.empty())
		for (FoundSetting& setting : matchingSettings(document, wanted))
			if (!setting.is_switch || setting.option != wanted)
				all.push_back({nullptr, {}, std::move(setting)});
	return all;
}

void carryOut(Desk& desk, const Found& what)
{
	Search& now = search();
	if (what.setting)
	{
		now.completion = what.setting->option + " ";
		return;
	}
	if (what.order)
	{
		if (const Status set = desk.document.set(what.order->setting.key, what.order->value); !set)
		{
			now.complaint = set.error().message;
			now.completion = now.wanted.data(); // for the user to mend
			return;
		}
	}
	desk.document.parts.command_search = false;
	if (what.command)
		desk.document.perform(what.command->action);
}

std::string wordsOf(const Found& what)
{
	if (what.command)
		return std::string(what.command->words);
	if (what.setting)
		return fmt::format("{} {}", what.setting->option, what.setting->values);
	return fmt::format("Set {} to {}", what.order->setting.option, what.order->value);
}

// Puts the completion where the user types on, behind its end.
int complete(ImGuiInputTextCallbackData* data)
{
	Search& now = search();
	if (now.completion.empty())
		return 0;
	data->DeleteChars(0, data->BufTextLen);
	data->InsertChars(0, now.completion.c_str());
	data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
	now.completion.clear();
	return 0;
}

void showField(bool appears)
{
	Search& now = search();
	if (appears)
		now = {};
	if (appears || !now.completion.empty())
		ImGui::SetKeyboardFocusHere();
	ImGui::SetNextItemWidth(-1.0f);
	ImGui::InputTextWithHint("##wanted", "A command, or a setting and its value: range 0 5", now.wanted.data(),
	                         now.wanted.size(), ImGuiInputTextFlags_CallbackAlways, complete);
	if (ImGui::IsItemEdited())
	{
		now.chosen = 0;
		now.complaint.clear();
	}
	if (!now.complaint.empty())
		ImGui::TextWrapped("%s", now.complaint.c_str());
}

// Returns true if the user has clicked the line.
bool showLine(const Found& what, bool is_chosen)
{
	const bool clicked = ImGui::Selectable(wordsOf(what).c_str(), is_chosen);
	if (is_chosen)
		ImGui::SetScrollHereY();
	if (!what.command)
	{
		const FoundSetting& setting = what.setting ? *what.setting : what.order->setting;
		tip(setting.help);
		if (is_chosen)
			ImGui::TextWrapped("%s", setting.help.c_str());
		return clicked;
	}
	const std::string keys = interact::keysOf(what.command->action);
	ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(keys.c_str()).x -
	                ImGui::GetStyle().ItemInnerSpacing.x);
	ImGui::TextDisabled("%s", keys.c_str());
	return clicked;
}

} // namespace

void showCommandSearch(Desk& desk)
{
	Search& now = search();
	const ImGuiViewport& all = *ImGui::GetMainViewport();
	const auto scale = static_cast<float>(desk.scale);
	ImGui::SetNextWindowPos({all.GetWorkCenter().x, all.WorkPos.y + 40.0f * scale}, ImGuiCond_Always, {0.5f, 0.0f});
	ImGui::SetNextWindowSize({std::min(440.0f * scale, 0.94f * all.WorkSize.x), 0.6f * all.WorkSize.y});
	if (ImGui::Begin("Find a command", &desk.document.parts.command_search,
	                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
	                     ImGuiWindowFlags_NoNav))
	{
		showField(ImGui::IsWindowAppearing());
		const std::vector<Found> lines = found(desk.document, now.wanted.data());
		const int last = static_cast<int>(lines.size()) - 1;
		OpenParts& parts = desk.document.parts;
		now.chosen = std::clamp(now.chosen + std::exchange(parts.search_steps, 0), 0, std::max(last, 0));
		const Found* taken = nullptr;
		ImGui::BeginChild("commands");
		for (int i = 0; i <= last; ++i)
		{
			const Found& line = lines[static_cast<std::size_t>(i)];
			ImGui::PushID(i);
			if (showLine(line, i == now.chosen))
				taken = &line;
			ImGui::PopID();
		}
		if (lines.empty())
			ImGui::TextDisabled("No command or setting has this in its name");
		ImGui::EndChild();
		if (std::exchange(parts.search_enters, false) && !lines.empty())
			taken = &lines[static_cast<std::size_t>(now.chosen)];
		if (taken)
			carryOut(desk, *taken);
	}
	ImGui::End();
}

} // namespace vp::app
