#pragma once

#include "viewer/widgets.h"

namespace vp::app
{

// The parts of the side panel. Each is drawn where its heading is unfolded.

void showDataSection(Desk& desk);
void showLoading(Desk& desk); // what is being loaded, for how long, and Cancel
void showProbeSection(Desk& desk);
void showPlaceFields(Desk& desk); // of the probe, or of one of its sheets
void showMagnifierSection(Desk& desk);
void showColorSection(Desk& desk);
void showColorMapChoice(Desk& desk);
void showRangeChoice(Desk& desk);
void showContourSection(Desk& desk);
void showSceneSection(Desk& desk);
void showVectorSection(Desk& desk);
void showTimeSection(Desk& desk);
void showCameraSection(Desk& desk);
void showSweepSection(Desk& desk);

} // namespace vp::app
