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

// None where the look leaves it to be fitted.
std::optional<render::Camera> cameraOf(const view::LookSpec& look);

} // namespace vp::app
