#pragma once

#include "render/scene/scene.h"
#include "session/session.h"

#include <optional>

namespace vp::session
{

/// Returns the span of an array's values, of all ranks where there are several: all call it then.
grid::ValueSpan spanOf(const Session& session, const grid::FieldChoice& field);
/// The same for the blocks of another time.
grid::ValueSpan spanOf(const grid::BlockSet& blocks, const ranks::Ranks& ranks, const grid::FieldChoice& field);

/// Returns the least value above 0 of an array, of all ranks, or 0.
double leastPositive(const grid::BlockSet& blocks, const ranks::Ranks& ranks, const grid::FieldChoice& field);

/// Returns the scale of an array, or nothing without an array. If the settings need values and the array has no
/// suitable ones, returns an input error. Warns of values that a logarithm leaves out. scan_window: the ends of a scan
/// are those of its window (scan_values.h).
Result<std::optional<render::ValueScale>> valueScale(const Session& session,
                                                     const std::optional<grid::FieldChoice>& field,
                                                     const render::Look& look, bool scan_window);

} // namespace vp::session
