#include "viewer/panels/widgets.h"

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

using interact::Binding;

struct HandWords
{
	const char* what;
	const char* does;
};

// The help lists what the mouse does, beside the keys.
constexpr std::array kHand{
    HandWords{"Drag a sheet", "Move it along its normal"},
    HandWords{"Drag an arrow, a ring", "Move, or turn, the probe"},
    HandWords{"Drag a side or corner", "Size the window"},
    HandWords{"Wheel on a sheet", "Push it along its normal"},
    HandWords{"Ctrl+wheel, or beside sheets", "Zoom to the pointer"},
    HandWords{"Drag beside, or right", "Turn the view"},
    HandWords{"Middle, or Shift+right", "Move the view"},
    HandWords{"Shift, Ctrl, Alt in a drag", "Fine; in round steps; the sheet alone, or both sides"},
    HandWords{"Click a number", "Type it; drag it to change it"},
};

void row(std::string_view keys, std::string_view words)
{
	ImGui::TableNextRow();
	ImGui::TableNextColumn();
	ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
	ImGui::TableNextColumn();
	ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

void groupHeading(std::string_view words)
{
	ImGui::TableNextRow();
	ImGui::TableNextColumn();
	ImGui::TextDisabled("%.*s", static_cast<int>(words.size()), words.data());
}

void listHand(std::string_view wanted)
{
	bool headed = false;
	for (const HandWords& words : kHand)
	{
		if (!containsText(words.what, wanted) && !containsText(words.does, wanted))
			continue;
		if (!headed)
			groupHeading("Mouse");
		headed = true;
		row(words.what, words.does);
	}
}

void listKeys(std::string_view wanted)
{
	const Binding* last = nullptr;
	for (const Binding& binding : interact::bindings())
	{
		const std::string keys = interact::keysOf(binding.action);
		if ((last && last->action == binding.action) ||
		    !(containsText(binding.words, wanted) || containsText(keys, wanted)))
			continue;
		if (!last || last->group != binding.group)
			groupHeading(binding.group);
		row(keys, binding.words);
		last = &binding;
	}
}

} // namespace

void showHelp(Desk& desk)
{
	static std::array<char, 64> wanted{};
	const ImGuiViewport& all = *ImGui::GetMainViewport();
	const auto scale = static_cast<float>(desk.scale);
	ImGui::SetNextWindowPos(all.GetWorkCenter(), ImGuiCond_Always, {0.5f, 0.5f});
	ImGui::SetNextWindowSize({std::min(600.0f * scale, 0.94f * all.WorkSize.x), 0.88f * all.WorkSize.y});
	if (ImGui::Begin("Keys and mouse", &desk.document.parts.help,
	                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
	{
		if (ImGui::IsWindowAppearing())
			ImGui::SetKeyboardFocusHere();
		ImGui::SetNextItemWidth(-1.0f);
		ImGui::InputTextWithHint("##wanted", "Search", wanted.data(), wanted.size());
		if (ImGui::BeginTable("list", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg))
		{
			ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 200.0f * scale);
			ImGui::TableSetupColumn("words", ImGuiTableColumnFlags_WidthStretch);
			listHand(wanted.data());
			listKeys(wanted.data());
			ImGui::EndTable();
		}
	}
	ImGui::End();
}

} // namespace vp::app
