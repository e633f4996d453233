#include "viewer/pointer/keyboard.h"

#include "viewer/pointer/key_codes.h"

#include <imgui/imgui.h>

#include <cctype>
#include <utility>

namespace vp::app
{

namespace
{

// Text that is typed right after Ctrl+K belongs to the search, even before the search has the focus.
bool isForInterface(const Document& document)
{
	return document.parts.command_search || ImGui::GetIO().WantTextInput ||
	       ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

} // namespace

void Keyboard::press(int key, bool down, int modifiers)
{
	hand_.setKeys(modifiersOf(key, down, modifiers));
	if (!down)
		return;
	const auto chord = chordOf(key, modifiers);
	// This works even while a text is being typed.
	if (chord == interact::Chord{interact::Key::escape} && closeQuestion())
		return;
	if (chord && document_.parts.command_search && searches(chord->key))
		return;
	const auto meant = chord ? interact::actionOf(*chord) : std::nullopt;
	const bool closes = meant == interact::Action::find_command && document_.parts.command_search;
	const auto action = closes || !isForInterface(document_) ? meant : std::nullopt;
	served_ = action.has_value();
	if (action)
		document_.perform(*action);
}

void Keyboard::type(char32_t character)
{
	const bool is_sign = character > U' ' && character < 0x7f && !std::isalnum(static_cast<unsigned char>(character));
	if (!is_sign || served_ || isForInterface(document_))
		return;
	if (const auto action = interact::actionOf({interact::key(character)}))
		document_.perform(*action);
}

bool Keyboard::searches(interact::Key key)
{
	OpenParts& parts = document_.parts;
	if (key == interact::Key::down)
		++parts.search_steps;
	else if (key == interact::Key::up)
		--parts.search_steps;
	else if (key == interact::Key::enter)
		parts.search_enters = true;
	else
		return false;
	return true;
}

// The question about a state to recover needs an answer, so Escape does not close it.
bool Keyboard::closeQuestion()
{
	const bool asks = document_.question != Question::none && document_.question != Question::recover;
	if (asks)
		document_.question = Question::none;
	const bool searches = std::exchange(document_.parts.command_search, false);
	return std::exchange(document_.parts.help, false) || searches || asks;
}

} // namespace vp::app
