#pragma once

#include "viewer/cutting/meter.h"
#include "viewer/document/document.h"
#include "viewer/panels/theme.h"
#include "viewer/pointer/pointer_controller.h"

#include <algorithm>
#include <cstdint>

namespace vp::app
{

// Everything that panels are drawn from.
struct Desk
{
	Document& document;
	PointerController& hand;
	const Meter& meter;
	double scale; // the screen's scale
};

// Returns the size of a part in whole pixels; none for a part that a small window has no room for.
inline PixelSize pixelsOf(const ScenePart& part)
{
	const auto whole = [](double side) { return static_cast<std::uint32_t>(std::max(0.0, side)); };
	return {whole(part.size.x), whole(part.size.y)};
}

// Each draws one part of the user interface, with ImGui, from the document's state and into it.

// Returns the place of the pane in the scene, which shows a sheet seen straight on.
ScenePart paneOf(const ScenePart& scene, double scale);

ScenePart showPanels(Desk& desk); // draws all panels, and returns the part of the window that is left for the scene
void showMenu(Desk& desk);
void showSidePanel(Desk& desk, const ScenePart& room);
void showStatusLine(Desk& desk, const ScenePart& room);
void showScene(Desk& desk, const ScenePart& part); // draws handles, and what is under the pointer
void followPointer(Desk& desk);                    // moves the contour that follows the pointer
void showPlanePane(Desk& desk, const ScenePart& part);
void showWayBack(Desk& desk, const ScenePart& part); // where the probe has left the data
void showNotices(Desk& desk, const ScenePart& part);
void showProfile(Desk& desk, const ScenePart& part);
void showStartPage(Desk& desk, const ScenePart& part); // before anything is loaded
void showHints(Desk& desk, const ScenePart& part);     // the first steps, one at a time
void showHelp(Desk& desk);
void showCommandSearch(Desk& desk);
void showQuestions(Desk& desk);

} // namespace vp::app
