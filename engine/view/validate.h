#pragma once

#include "view/view_spec.h"

namespace vp::view
{

/// Tells what cannot be, before any input is read: a usage error that names the setting and the remedy. Numbers out of
/// their limits, settings that do not go together. A data set may still lack what is asked for; resolve() tells that.
Status validate(const ViewSpec& spec);

/// Of what shows one surface: a usage error where a range of grid surfaces is given.
Status requireOneSurface(const ProbeSpec& probe);

/// Of a sweep: a usage error where the path is none for a surface.
Status requirePathOfSurface(const ProbeSpec& probe, const SweepSpec& sweep);

/// Colors by generation are of traversals, and a grid surface is found without: a usage error.
Status refuseGenerations(const ProbeSpec& probe, ColorBy color_by);

/// Of what needs planes: flat pictures, lines through a sheet. A usage error.
Status requirePlanes(const ProbeSpec& probe);

} // namespace vp::view
