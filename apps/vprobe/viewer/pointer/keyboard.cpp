#include "viewer/pointer/keyboard.h"

#include "viewer/document/action_state.h"
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

// While keys move through the panel, those that no control uses still do what they do elsewhere.
bool isForPanel(const interact::Chord& chord)
{
	return !chord.ctrl && chord.key < interact::Key::f1;
}

// An action that a menu shows in gray has no key either. Escape always has something to close.
bool mayPerform(const Document& document, interact::Action action)
{
	return action == interact::Action::cancel || isPossible(document, action);
}

} // namespace

void Keyboard::press(int key, bool down, int modifiers)
{
	hand_.setKeys(modifiersOf(key, down, modifiers));
	const auto chord = chordOf(key, modifiers);
	if (chord && (chord->key == interact::Key::left || chord->key == interact::Key::right))
		holds_sideways_ = down;
	if (!down)
		return;
	if (chord && !chord->ctrl && !chord->alt)
		pressed_.push_back(chord->key);
	// This works even while a text is being typed.
	if (chord == interact::Chord{interact::Key::escape} && closeQuestion())
		return;
	if (chord && document_.parts.command_search && searches(chord->key))
		return;
	if (document_.parts.panel_keys && chord && isForPanel(*chord))
		return leavePanel(*chord);
	const auto meant = chord ? interact::actionOf(*chord) : std::nullopt;
	// The search opens and closes while a text is being typed, too. On a slow machine a text field that is gone has the
	// keyboard for another frame.
	const bool searches = meant == interact::Action::find_command && document_.question == Question::none;
	const auto action = searches || !isForInterface(document_) ? meant : std::nullopt;
	served_ = action.has_value();
	if (action && mayPerform(document_, *action))
		document_.perform(*action);
}

// Escape closes a list of the panel first.
void Keyboard::leavePanel(const interact::Chord& chord)
{
	served_ = true;
	if (chord.key == interact::Key::escape && !isForInterface(document_))
		document_.parts.panel_keys = false;
}

void Keyboard::type(char32_t character)
{
	const bool is_sign = character > U' ' && character < 0x7f && !std::isalnum(static_cast<unsigned char>(character));
	if (!is_sign || served_ || isForInterface(document_) || document_.parts.panel_keys)
		return;
	if (const auto action = interact::actionOf({interact::key(character)}); action && mayPerform(document_, *action))
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

// A state to recover that is neither taken nor forgotten is offered again by the next window.
bool Keyboard::closeQuestion()
{
	const bool asks = document_.question != Question::none;
	if (asks)
		document_.question = Question::none;
	const bool searches = std::exchange(document_.parts.command_search, false);
	return std::exchange(document_.parts.help, false) || searches || asks;
}

} // namespace vp::app
