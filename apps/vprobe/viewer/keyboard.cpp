#include "viewer/keyboard.h"

#include "viewer/key_codes.h"

#include <imgui/imgui.h>

#include <cctype>
#include <utility>

namespace vp::app
{

namespace
{

bool isForInterface()
{
	return ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

} // namespace

void Keyboard::press(int key, bool down, int modifiers)
{
	hand_.setKeys(modifiersOf(key, down, modifiers));
	if (!down)
		return;
	const auto chord = chordOf(key, modifiers);
	// Also where a text is being typed.
	if (chord == interact::Chord{interact::Key::escape} && closeQuestion())
		return;
	const auto action = chord && !isForInterface() ? interact::actionOf(*chord) : std::nullopt;
	served_ = action.has_value();
	if (action)
		bench_.perform(*action);
}

void Keyboard::type(char32_t character)
{
	const bool is_sign = character > U' ' && character < 0x7f && !std::isalnum(static_cast<unsigned char>(character));
	if (!is_sign || served_ || isForInterface())
		return;
	if (const auto action = interact::actionOf({interact::key(character)}))
		bench_.perform(*action);
}

// What was left to be recovered wants an answer.
bool Keyboard::closeQuestion()
{
	const bool asks = bench_.question != Question::none && bench_.question != Question::recover;
	if (asks)
		bench_.question = Question::none;
	return std::exchange(bench_.parts.help, false) || asks;
}

} // namespace vp::app
