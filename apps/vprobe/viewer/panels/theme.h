#pragma once

#include <imgui/imgui.h>

namespace vp::app
{

// The look of the user interface: one calm theme, dark and light.

// Colors beside ImGui's own.
struct Theme
{
	ImU32 handle[3]; // x, up, normal
	ImU32 window_rim;
	ImU32 held; // a handle that is under the pointer, or dragged
	ImU32 note;
	ImU32 error;
	ImU32 graph[4]; // frame, cut, draw, input to picture
};

const Theme& theme(bool dark);

// Sets ImGui's style, and its font in pixels that suit the screen's scale. After a change of scale, the screen has to
// take the fonts.
void applyTheme(bool dark, double scale);
void makeFonts(double scale);

} // namespace vp::app
