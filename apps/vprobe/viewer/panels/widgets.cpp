#include "viewer/panels/widgets.h"

#include "view/settings.h"

#include "interact/steps.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace vp::app
{

namespace
{

constexpr double kRestSeconds = 0.4;   // time until a tip appears
constexpr double kPixelsAcross = 1000; // pixels of a drag across the whole data
constexpr float kTipLetters = 40.0f;   // letters per line
constexpr float kLabelPart = 0.36f;    // part of the line

// Returns a setting of the state. Its place is read only.
view::Setting shownSetting(const Desk& desk, const char* key)
{
	return view::settingOf(const_cast<view::ViewSpec&>(desk.document.state()), key);
}

} // namespace

bool pointerRests()
{
	static double moved = 0.0;
	static ImVec2 last;
	const ImGuiIO& io = ImGui::GetIO();
	if (io.MousePos.x != last.x || io.MousePos.y != last.y || io.MouseDown[0])
		moved = ImGui::GetTime();
	last = io.MousePos;
	return ImGui::GetTime() - moved > kRestSeconds;
}

void beginFixed(const char* name, const ScenePart& room, ImGuiWindowFlags more, bool takes_keys)
{
	if (!takes_keys)
		more |= ImGuiWindowFlags_NoNav;
	ImGui::SetNextWindowPos({static_cast<float>(room.lo.x), static_cast<float>(room.lo.y)});
	ImGui::SetNextWindowSize({static_cast<float>(room.size.x), static_cast<float>(room.size.y)});
	ImGui::Begin(name, nullptr,
	             ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
	                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
	                 ImGuiWindowFlags_NoBackground | more); // the screen has its color already (gpu_screen.cpp)
}

void tip(std::string_view words)
{
	if (words.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || !pointerRests())
		return;
	ImGui::BeginTooltip();
	ImGui::PushTextWrapPos(kTipLetters * ImGui::GetFontSize() * 0.5f);
	ImGui::TextUnformatted(words.data(), words.data() + words.size());
	ImGui::PopTextWrapPos();
	ImGui::EndTooltip();
}

std::string tipOf(interact::Action action)
{
	const std::string keys = interact::keysOf(action);
	return keys.empty() ? std::string(interact::wordsOf(action))
	                    : fmt::format("{} ({})", interact::wordsOf(action), keys);
}

bool actionButton(Desk& desk, interact::Action action, const char* label, float width)
{
	ImGui::BeginDisabled(!isPossible(desk.document, action));
	const bool pressed = ImGui::Button(label, {width, 0.0f});
	ImGui::EndDisabled();
	tip(tipOf(action));
	if (pressed)
		desk.document.perform(action);
	return pressed;
}

void actionItem(Desk& desk, interact::Action action)
{
	if (ImGui::MenuItem(std::string(interact::wordsOf(action)).c_str(), interact::keysOf(action).c_str(),
	                    isOn(desk.document, action), isPossible(desk.document, action)))
		desk.document.perform(action);
}

void focusLastItem()
{
	ImGuiContext& now = *ImGui::GetCurrentContext();
	ImGui::SetFocusID(now.LastItemData.ID, now.CurrentWindow);
	now.NavDisableHighlight = false;
	now.NavDisableMouseHover = true; // until the mouse moves
}

float shareOfLine(int count)
{
	const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemInnerSpacing.x;
	return std::max(1.0f, (ImGui::GetContentRegionAvail().x - gaps) / static_cast<float>(count));
}

void labeled(const char* label)
{
	const float room = ImGui::GetContentRegionAvail().x;
	const float start = ImGui::GetCursorPosX();
	ImGui::AlignTextToFramePadding();
	ImGui::TextUnformatted(label);
	ImGui::SameLine(start + kLabelPart * room);
	ImGui::SetNextItemWidth(-1.0f);
}

void toggle(Desk& desk, const char* label, bool now, std::string_view words, const Document::Edit& edit)
{
	if (ImGui::Checkbox(label, &now))
		desk.document.change(label, edit);
	tip(words);
}

void toggle(Desk& desk, const char* label, const char* key)
{
	const view::Setting setting = shownSetting(desk, key);
	toggle(desk, label, *std::get<bool*>(setting.place), setting.help,
	       [key](view::ViewSpec& state)
	       {
		       bool& value = *std::get<bool*>(view::settingOf(state, key).place);
		       value = !value;
	       });
}

void showChoice(Desk& desk, const char* label, std::span<const Choice> choices, const std::string& now,
                std::string_view words, const std::function<void(view::ViewSpec& state, const char* word)>& set)
{
	const auto known = std::ranges::find(choices, now, [](const Choice& choice) { return std::string(choice.word); });
	labeled(label);
	if (ImGui::BeginCombo(fmt::format("##{}", label).c_str(), known == choices.end() ? now.c_str() : known->name))
	{
		for (const Choice& choice : choices)
		{
			ImGui::PushID(choice.word); // names may be alike
			if (ImGui::Selectable(choice.name, now == choice.word))
				desk.document.change(label, [&](view::ViewSpec& state) { set(state, choice.word); });
			ImGui::PopID();
		}
		ImGui::EndCombo();
	}
	tip(words);
}

void showSlider(Desk& desk, const Slide& slide, double now, std::string_view words,
                const std::function<void(view::ViewSpec& state, double value)>& set)
{
	auto value = static_cast<float>(now);
	labeled(slide.label);
	if (ImGui::SliderFloat(fmt::format("##{}", slide.label).c_str(), &value, static_cast<float>(slide.least),
	                       static_cast<float>(slide.most), slide.format,
	                       ImGuiSliderFlags_AlwaysClamp | (slide.logarithmic ? ImGuiSliderFlags_Logarithmic : 0)))
		desk.document.change(
		    slide.label, [&](view::ViewSpec& state) { set(state, value); }, slide.label);
	if (ImGui::IsItemDeactivated())
		desk.document.endMerge();
	tip(words);
}

void showSlider(Desk& desk, const Slide& slide, const char* key)
{
	const view::Setting setting = shownSetting(desk, key);
	showSlider(desk, slide, *std::get<double*>(setting.place), setting.help,
	           [key](view::ViewSpec& state, double value)
	           { *std::get<double*>(view::settingOf(state, key).place) = value; });
}

bool dragNumbers(Desk& desk, const Drag& drag, double* numbers, int count, std::string_view words)
{
	const bool bounded = drag.least < drag.most;
	const bool changed =
	    ImGui::DragScalarN(drag.id, ImGuiDataType_Double, numbers, count, static_cast<float>(drag.speed),
	                       bounded ? &drag.least : nullptr, bounded ? &drag.most : nullptr, drag.format,
	                       ImGuiSliderFlags_AlwaysClamp | (drag.logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
	tip(words);
	if (ImGui::IsItemDeactivated() && !changed)
		desk.document.endMerge();
	return changed;
}

double lengthSpeed(const Desk& desk)
{
	return desk.document.facts() ? interact::sizeOf(desk.document.facts()->bounds) / kPixelsAcross : 0.01;
}

void clippedText(const std::string& text)
{
	const float room = ImGui::GetContentRegionAvail().x;
	if (ImGui::CalcTextSize(text.c_str()).x <= room)
		return ImGui::TextUnformatted(text.c_str());
	// The end of a path says more than its beginning.
	std::size_t from = 0;
	std::string shown;
	do
	{
		++from;
		while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xc0u) == 0x80u)
			++from; // not within a letter
		shown = "\u2026" + text.substr(from);
	} while (from < text.size() && ImGui::CalcTextSize(shown.c_str()).x > room);
	ImGui::TextUnformatted(shown.c_str());
	tip(text);
}

bool containsText(std::string_view text, std::string_view wanted)
{
	return std::search(text.begin(), text.end(), wanted.begin(), wanted.end(),
	                   [](unsigned char a, unsigned char b)
	                   { return std::tolower(a) == std::tolower(b); }) != text.end();
}

std::string grouped(std::size_t number)
{
	std::string digits = fmt::format("{}", number);
	for (std::size_t at = digits.size(); at > 3; at -= 3)
		digits.insert(at - 3, "\u2009");
	return digits;
}

std::string bytes(double count)
{
	constexpr std::array kUnits{"B", "KiB", "MiB", "GiB", "TiB"};
	std::size_t unit = 0;
	for (; count >= 1000.0 && unit + 1 < kUnits.size(); ++unit)
		count /= 1024.0;
	return fmt::format("{:.3g} {}", count, kUnits[unit]);
}

} // namespace vp::app
