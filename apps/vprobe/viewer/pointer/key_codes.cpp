#include "viewer/pointer/key_codes.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cctype>
#include <string_view>

namespace vp::app
{

namespace
{

using interact::Key;

std::optional<Key> namedKey(int key)
{
	if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
		return static_cast<Key>(static_cast<char32_t>(Key::f1) + static_cast<char32_t>(key - GLFW_KEY_F1));
	switch (key)
	{
	case GLFW_KEY_SPACE:
		return Key::space;
	case GLFW_KEY_ESCAPE:
		return Key::escape;
	case GLFW_KEY_ENTER:
	case GLFW_KEY_KP_ENTER:
		return Key::enter;
	case GLFW_KEY_TAB:
		return Key::tab;
	case GLFW_KEY_BACKSPACE:
		return Key::backspace;
	case GLFW_KEY_INSERT:
		return Key::insert;
	case GLFW_KEY_DELETE:
		return Key::remove;
	case GLFW_KEY_LEFT:
		return Key::left;
	case GLFW_KEY_RIGHT:
		return Key::right;
	case GLFW_KEY_UP:
		return Key::up;
	case GLFW_KEY_DOWN:
		return Key::down;
	case GLFW_KEY_PAGE_UP:
		return Key::page_up;
	case GLFW_KEY_PAGE_DOWN:
		return Key::page_down;
	case GLFW_KEY_HOME:
		return Key::home;
	case GLFW_KEY_END:
		return Key::end;
	default:
		return std::nullopt;
	}
}

// Returns the key by the letter printed on it in the keyboard's own layout.
std::optional<Key> printedKey(int key)
{
	const char* name = glfwGetKeyName(key, 0);
	if (!name || std::string_view(name).size() != 1)
		return std::nullopt;
	return interact::key(static_cast<char32_t>(std::tolower(static_cast<unsigned char>(*name))));
}

} // namespace

std::optional<interact::Chord> chordOf(int key, int modifiers)
{
	std::optional<Key> known = namedKey(key);
	if (!known)
		known = printedKey(key);
	if (!known)
		return std::nullopt;
	return interact::Chord{*known, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0,
	                       (modifiers & GLFW_MOD_ALT) != 0};
}

std::optional<Button> buttonOf(int button)
{
	switch (button)
	{
	case GLFW_MOUSE_BUTTON_LEFT:
		return Button::left;
	case GLFW_MOUSE_BUTTON_RIGHT:
		return Button::right;
	case GLFW_MOUSE_BUTTON_MIDDLE:
		return Button::middle;
	default:
		return std::nullopt;
	}
}

interact::Modifiers modifiersOf(int key, bool down, int modifiers)
{
	// When a modifier's own key is pressed, GLFW reports the modifiers from before it.
	const auto held = [&](int bit, int left, int right)
	{ return key == left || key == right ? down : (modifiers & bit) != 0; };
	interact::Modifiers keys;
	keys.fine = held(GLFW_MOD_SHIFT, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
	keys.snap = held(GLFW_MOD_CONTROL, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
	keys.own = held(GLFW_MOD_ALT, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
	return keys;
}

} // namespace vp::app
