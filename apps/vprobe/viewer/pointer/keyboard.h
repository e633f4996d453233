#pragma once

#include "viewer/document/document.h"
#include "viewer/pointer/pointer_controller.h"

#include <utility>
#include <vector>

namespace vp::app
{

// Handles keys that are not meant for a text field or a menu.
class Keyboard
{
public:
	Keyboard(Document& document, PointerController& hand) : document_(document), hand_(hand) {}

	void press(int key, bool down, int modifiers); // key and modifiers as GLFW numbers them
	// Handles a typed character, right after its key. Signs such as ? are on different keys on different keyboards.
	void type(char32_t character);

	// Returns true while the left or right arrow key is down.
	bool holdsSideways() const { return holds_sideways_; }
	// Returns the arrow keys and Enter that went down since the last call. ImGui sees a key only while it is down, and
	// a quick one may be up again between two frames.
	std::vector<interact::Key> takePressed() { return std::exchange(pressed_, {}); }

private:
	bool closeQuestion();
	void leavePanel(const interact::Chord& chord);
	bool searches(interact::Key key); // handles a key of the search for commands; false if the search does not use it

	Document& document_;
	PointerController& hand_;
	std::vector<interact::Key> pressed_;
	bool holds_sideways_ = false;
	bool served_ = false; // the last key that went down did something
};

} // namespace vp::app
