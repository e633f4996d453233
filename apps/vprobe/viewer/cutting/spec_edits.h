#pragma once

#include "probe/probe.h"
#include "render/scene/camera.h"
#include "view/view_spec.h"

#include <optional>

namespace vp::app
{

// A probe that was made of the settings, `before`, comes to be `after`: its place as settings, anything else as a probe
// of its own.
void placeProbe(view::ProbeSpec& spec, const probe::Probe& before, const probe::Probe& after);

// Where the probe is and of what sheets, as the other settings have it. Cuts that differ in no more share what their
// unmoved sheets show.
void takePlace(view::ProbeSpec& spec, const view::ProbeSpec& from);

// None where the look leaves it to be fitted.
std::optional<render::Camera> cameraOf(const view::LookSpec& look);

} // namespace vp::app
