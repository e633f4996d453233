#pragma once

#include "exit_code.h"
#include "session/session.h"

#include <nlohmann/json_fwd.hpp>

namespace vp::app
{

// --explain: opens the input as the command would, prints which way the first cut goes, a line for each sheet in each
// block, and cuts nothing.
Result<ExitCode> explain(const view::ViewSpec& spec, const session::OpenOptions& how);

// The same in a document: [{"block", "sheet", "strategy", "classifier", "reason"}].
nlohmann::json planJson(const session::Session& session);

} // namespace vp::app
