#pragma once

#include "render/scene/scene.h"
#include "session/session.h"

#include <optional>

namespace vp::session
{

/// Returns the scale of an array, or nothing without an array. If the settings need values and the array has no
/// suitable ones, returns an input error. Warns of values that a logarithm leaves out.
Result<std::optional<render::ValueScale>>
valueScale(const Session& session, const std::optional<grid::FieldChoice>& field, const render::Look& look);

} // namespace vp::session
