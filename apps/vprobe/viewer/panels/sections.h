#pragma once

#include "viewer/panels/widgets.h"

namespace vp::app
{

// Says when a section has something to show.
enum class ShownWhen
{
	always,
	loaded,
	times,  // the input has several times
	vectors // the input has arrays of vectors
};

// The sections of the side panel, in order: X(heading, tooltip, function, when it is shown, unfolded at first). Each
// function is in a file of its own, and is called if its heading is unfolded.
#define VP_SECTIONS(X)                                                                                                 \
	X("Data", "What is loaded", showDataSection, always, true)                                                         \
	X("Probe", "The sheets, where they stand, their windows", showProbeSection, loaded, true)                          \
	X("Colors", "What array the sheets show, and how", showColorSection, loaded, true)                                 \
	X("Color map", "The map, and how opaque each value is", showColorMapSection, loaded, false)                        \
	X("Vectors", "Arrows, and paths of particles, launched from the sheets", showVectorSection, vectors, false)        \
	X("Contours", "Surfaces of one value, grown from the sheets", showContourSection, loaded, false)                   \
	X("Time", "The input's time steps", showTimeSection, times, true)                                                  \
	X("Sweep", "The probe moved along a path, as a film", showSweepSection, loaded, false)                             \
	X("Magnifier", "What a sheet shows, magnified", showMagnifierSection, loaded, false)                               \
	X("Scene", "What is drawn around the sheets", showSceneSection, loaded, false)                                     \
	X("Camera", "Where the scene is seen from", showCameraSection, loaded, false)

#define VP_DECLARE(name, tip, show, when, unfolded) void show(Desk& desk);
VP_SECTIONS(VP_DECLARE)
#undef VP_DECLARE

// These functions show parts of sections.
void showLoading(Desk& desk);     // shows what is being loaded, for how long, and a Cancel button
void showPlaceFields(Desk& desk); // shows the place of the probe, or of one of its sheets
void showColorMapChoice(Desk& desk);
void showRangeChoice(Desk& desk);

} // namespace vp::app
