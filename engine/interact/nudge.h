#pragma once

#include "interact/placing.h"
#include "interact/view.h"
#include "interact/window_size.h"

#include <cstddef>

namespace vp::interact
{

// How wheel and keys move a probe step by step; see also placing.h.

// Along a sheet's normal, `steps` round steps (roundStep) of the bounds forward; negative ones go back. fine: a tenth.
// own: the sheet alone, else the whole probe.
probe::Probe pushed(const probe::Probe& probe, std::size_t sheet, double steps, const Box& bounds, bool fine = false,
                    bool own = false);

// A part turned about an axis of its own: 0, 1, 2 for x, up and normal.
probe::Probe turnedAbout(const probe::Probe& probe, const Part& part, int axis, double degrees);

// A sheet's window, and those equal to it but for `own`, `factor` times as large about its center, or about a point in
// the sheet's coordinates. Unchanged where the sheet has none.
probe::Probe withWindowScaled(const probe::Probe& probe, std::size_t sheet, double factor, const Box& bounds,
                              bool own = false);
probe::Probe withWindowScaled(const probe::Probe& probe, std::size_t sheet, double factor, const glm::dvec2& about,
                              const Box& bounds, bool own = false);

// The magnifier: what a sheet shows is magnified `factor` times more, and what is shown at `uv` (in the sheet's
// coordinates as drawn, see SheetHit) stays there. The magnification stays within kMinMagnification and
// kMaxMagnification, or what it was.
probe::Probe magnified(const probe::Probe& probe, std::size_t sheet, double factor, const glm::dvec2& uv);
constexpr double kMinMagnification = 1e-3;
constexpr double kMaxMagnification = 1e6;

// Pans the magnifier, so that the content shown at `from` is then shown at `to`.
probe::Probe magnifierPanned(const probe::Probe& probe, std::size_t sheet, const glm::dvec2& from,
                             const glm::dvec2& to);

// Removes the magnifier (fx), so that the sheet shows the content at its own place.
probe::Probe withoutMagnifier(const probe::Probe& probe, std::size_t sheet);

// A part turned to face the eye, by the least angle.
probe::Probe withNormalToCamera(const probe::Probe& probe, const Part& part, const render::Camera& camera);

} // namespace vp::interact
