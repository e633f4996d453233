#pragma once

#include "base/result.h"
#include "look_options.h"
#include "path_options.h"
#include "probe/probe.h"
#include "probe_options.h"
#include "render/scene/camera.h"
#include "saved_options.h"

#include <optional>
#include <string>

namespace vp::app
{

// Everything that is set in a window: what --save keeps, as a value that can be compared, undone and done again.
struct ViewState
{
	ProbeOptions probe;
	LookOptions look;
	PathOptions path;

	bool operator==(const ViewState&) const = default;
};

SavedOptions savedOptions(const ViewState& state, const std::string& file);

// A probe that was made of the options, `before`, comes to be `after`: its place as options, anything else as a probe
// of its own.
void placeProbe(ProbeOptions& options, const probe::Probe& before, const probe::Probe& after);

// Where the probe is and of what sheets, as the other options have it. Cuts that differ in no more share what their
// unmoved sheets show.
void takePlace(ProbeOptions& options, const ProbeOptions& from);

// None where the look leaves it to be fitted.
std::optional<render::Camera> cameraOf(const LookOptions& look);
void setCamera(LookOptions& look, const render::Camera& camera);

} // namespace vp::app
