#pragma once

#include "render/scene/scene.h"
#include "session/session.h"

#include <optional>

namespace vp::session
{

/// The scale of an array, none without one. Settings that need values are an input error where there are none that
/// serve; values that a logarithm leaves out are a warning.
Result<std::optional<render::ValueScale>>
valueScale(const Session& session, const std::optional<grid::FieldChoice>& field, const render::Look& look);

} // namespace vp::session
