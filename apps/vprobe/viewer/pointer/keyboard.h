#pragma once

#include "viewer/document/document.h"
#include "viewer/pointer/pointer_controller.h"

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

private:
	bool closeQuestion();
	bool searches(interact::Key key); // handles a key of the search for commands; false if the search does not use it

	Document& document_;
	PointerController& hand_;
	bool served_ = false; // the last key that went down did something
};

} // namespace vp::app
