#pragma once

#include "view/view_spec.h"

namespace vp::view
{

/// Checks the settings before any input is read: numbers within their limits, settings that fit together. A usage error
/// names the setting and the remedy. Whether a data set has what the settings ask for is checked by resolve().
Status validate(const ViewSpec& spec);

/// For commands that show one surface: returns a usage error for a range of grid surfaces.
Status requireOneSurface(const ProbeSpec& probe);

/// For sweeps: returns a usage error if the path does not move the surface.
Status requirePathOfSurface(const ProbeSpec& probe, const SweepSpec& sweep);

/// Returns a usage error for colors by generation on a grid surface, which is found without a traversal.
Status refuseGenerations(const ProbeSpec& probe, ColorBy color_by);

/// For commands that look at linear cells: returns a usage error if `refine` is a tolerance. who: "vprobe check".
Status requireLevel(const InputSpec& input, const char* who);

/// For flat pictures and lines through a sheet: returns a usage error if the sheets are not planes.
Status requirePlanes(const ProbeSpec& probe);

} // namespace vp::view
