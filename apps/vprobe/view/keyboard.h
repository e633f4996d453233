#pragma once

#include "view/hand.h"
#include "view/workbench.h"

namespace vp::app
{

// What keys do that are not meant for a text field or a menu.
class Keyboard
{
public:
	Keyboard(Workbench& bench, Hand& hand) : bench_(bench), hand_(hand) {}

	void press(int key, bool down, int modifiers); // as GLFW numbers them
	// Right after its key: signs such as ? are typed by different keys on different keyboards.
	void type(char32_t character);

private:
	bool closeQuestion();

	Workbench& bench_;
	Hand& hand_;
	bool served_ = false; // the last key that went down meant something
};

} // namespace vp::app
