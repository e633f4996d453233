#pragma once

#include <string>

namespace vp::view
{

/// Returns the JSON Schema (draft 7) of state files. It refers to docs/probe.schema.json and docs/path.schema.json.
std::string stateSchema();

} // namespace vp::view
