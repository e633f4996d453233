#pragma once

#include "exit_code.h"

#include "session.h"

#include <nlohmann/json_fwd.hpp>

namespace vp::app
{

// --explain: opens the input, prints which way the first cut goes, a line for each sheet in each block, and cuts
// nothing.
Result<ExitCode> explain(const ProbeOptions& options, bool by_generation = false);

// The same in a document: [{"block", "sheet", "strategy", "classifier", "reason"}].
nlohmann::json planJson(const Session& session);

} // namespace vp::app
