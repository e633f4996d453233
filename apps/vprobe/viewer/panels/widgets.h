#pragma once

#include "viewer/document/action_state.h"
#include "viewer/panels/panels.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace vp::app
{

// Controls for panels. Each has a tooltip, and each change is a step of the history.

// Begins a part of the window that stays where it is. takes_keys: the keyboard moves through it.
void beginFixed(const char* name, const ScenePart& room, ImGuiWindowFlags more = 0, bool takes_keys = false);

bool pointerRests(); // returns true if the pointer has been still for a moment

// Shows a tooltip for the last control when the pointer rests on it.
void tip(std::string_view words);
std::string tipOf(interact::Action action); // returns what the action does, and its keys: "Show the next array (A)"

// A button with `label` that performs the action. Its tooltip is tipOf().
bool actionButton(Desk& desk, interact::Action action, const char* label, float width = 0.0f);
void actionItem(Desk& desk, interact::Action action); // an item of a menu, with a check mark if it is on

// Gives the keyboard to the last control, and shows that it has it.
void focusLastItem();

// Returns the width of one of `count` controls that share the rest of the line.
float shareOfLine(int count);

// Puts a label on the left of the line, and the next control on the right.
void labeled(const char* label);

// Shows a check box that changes the state.
void toggle(Desk& desk, const char* label, bool now, std::string_view words, const Document::Edit& edit);
// The same for a setting (view/settings.h) that is true or false. The tip is its help.
void toggle(Desk& desk, const char* label, const char* key);

// A word for an option, and the name that the user sees. A value that is none of these words is shown as it is.
struct Choice
{
	const char* word;
	const char* name;
};
void showChoice(Desk& desk, const char* label, std::span<const Choice> choices, const std::string& now,
                std::string_view words, const std::function<void(view::ViewSpec& state, const char* word)>& set);

// A slider from `least` to `most`.
struct Slide
{
	const char* label;
	double least = 0.0;
	double most = 1.0;
	const char* format = "%.2f";
	bool logarithmic = false;
};
void showSlider(Desk& desk, const Slide& slide, double now, std::string_view words,
                const std::function<void(view::ViewSpec& state, double value)>& set);
// The same for a setting that is a number. The tip is its help.
void showSlider(Desk& desk, const Slide& slide, const char* key);

// Shows `count` numbers side by side. The user drags them, or types after a click. Returns true while they change. When
// the change ends, so does its step of the history.
struct Drag
{
	const char* id;
	double speed;       // change per pixel
	double least = 0.0; // both limits apply if least < most
	double most = 0.0;
	const char* format = "%.5g";
	bool logarithmic = false;
};
bool dragNumbers(Desk& desk, const Drag& drag, double* numbers, int count, std::string_view words);

// Returns how far a length changes per dragged pixel, by the size of the data.
double lengthSpeed(const Desk& desk);

// Shows the end of a text that is too long for the line, and the whole text in a tooltip.
void clippedText(const std::string& text);

// Returns true if `text` contains `wanted`; upper and lower case are the same.
bool containsText(std::string_view text, std::string_view wanted);

// Returns a whole number in groups of three digits: "16 777 216".
std::string grouped(std::size_t number);
std::string bytes(double count); // "1.8 GiB"

} // namespace vp::app
