#pragma once

#include "exit_code.h"
#include "session/session.h"

#include <nlohmann/json_fwd.hpp>

namespace vp::app
{

// Carries out --explain: opens the input as the command would, and prints how the first cut would be made, one line for
// each sheet in each block. Cuts nothing.
Result<ExitCode> explain(const view::ViewSpec& spec, session::OpenOptions how);

// Returns the same as JSON: [{"block", "sheet", "strategy", "classifier", "reason"}].
nlohmann::json planJson(const session::Session& session);

} // namespace vp::app
