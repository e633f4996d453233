#pragma once

#include "viewer/document.h"
#include "viewer/pointer_controller.h"

namespace vp::app
{

// What keys do that are not meant for a text field or a menu.
class Keyboard
{
public:
	Keyboard(Document& document, PointerController& hand) : document_(document), hand_(hand) {}

	void press(int key, bool down, int modifiers); // as GLFW numbers them
	// Right after its key: signs such as ? are typed by different keys on different keyboards.
	void type(char32_t character);

private:
	bool closeQuestion();
	bool searches(interact::Key key); // what a key means to the search for commands; false for nothing

	Document& document_;
	PointerController& hand_;
	bool served_ = false; // the last key that went down meant something
};

} // namespace vp::app
