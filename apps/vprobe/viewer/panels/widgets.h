#pragma once

#include "viewer/panels/panels.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace vp::app
{

// Controls for panels. Each has a tooltip, and each change is a step of the history.

// A part of the window that stays where it is.
void beginFixed(const char* name, const ScenePart& room, ImGuiWindowFlags more = 0);

bool pointerRests(); // returns true if the pointer has been still for a moment

// Shows a tooltip for the last control when the pointer rests on it.
void tip(std::string_view words);
std::string tipOf(interact::Action action); // what it does, and its keys: "Show the next array (A)"

// A button with `label` that performs the action. Its tooltip is tipOf().
bool actionButton(Desk& desk, interact::Action action, const char* label, float width = 0.0f);
void actionItem(Desk& desk, interact::Action action); // an item of a menu, with a check mark if it is on
bool isOn(const Document& document, interact::Action action);
bool isPossible(const Document& document, interact::Action action);

// Returns the width of one of `count` controls that share the rest of the line.
float shareOfLine(int count);

// A label on the left, the control that follows on the right of the line.
void labeled(const char* label);

// A check box that changes the state.
void toggle(Desk& desk, const char* label, bool now, std::string_view words, const Document::Edit& edit);

// One of several words for an option, by names that a reader knows. The value may be none of them: then it is shown as
// it is.
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

// Numbers to be dragged, or typed after a click; `count` of them side by side. True while they change; when that ends,
// so does the step of the history that they belong to.
struct Drag
{
	const char* id;
	double speed;       // a pixel
	double least = 0.0; // where it is below `most`
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

// Whole numbers in groups of three: "16 777 216".
std::string grouped(std::size_t number);
std::string bytes(double count); // "1.8 GiB"

} // namespace vp::app
