#pragma once

#include "probe/probe.h"

#include <cstddef>

namespace vp::interact
{

// Bounds of a window's sides, as parts of the scene's size (sizeOf, steps.h). Near-wall cells are 1e-6 of a domain.
constexpr double kSmallestWindow = 1e-6;
constexpr double kLargestWindow = 100.0;

// A side moved along its axis: 0 to 3 for x0, x1, y0, y1. The opposite one stays to the last bit, or goes as far the
// other way. A size beyond the bounds may stay what it is.
probe::Window withSideMoved(const probe::Window& window, int side, double way, bool both_sides, double scene_size);

// All of it `factor` (> 0) times as large about a point, in the sheet's coordinates; within the bounds, and in its
// proportions.
probe::Window scaled(const probe::Window& window, double factor, const glm::dvec2& about, double scene_size);

// The probe with another window for a sheet that has one, and for all sheets whose windows are equal to that; `own`:
// for it alone.
probe::Probe withWindow(const probe::Probe& probe, std::size_t sheet, const probe::Window& window, bool own);

} // namespace vp::interact
