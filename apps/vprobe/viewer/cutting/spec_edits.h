#pragma once

#include "probe/probe.h"
#include "render/scene/camera.h"
#include "view/view_spec.h"

#include <optional>

namespace vp::app
{

// Changes the settings, which made the probe `before`, so that they make `after`. A new place changes the settings of
// the place. Any other change makes the probe one of its own (ProbeShape::own).
void placeProbe(view::ProbeSpec& spec, const probe::Probe& before, const probe::Probe& after);

// Returns the camera of the look. Returns nothing if the camera is to be fitted.
std::optional<render::Camera> cameraOf(const view::LookSpec& look);

} // namespace vp::app
