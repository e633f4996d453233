#pragma once

#include "session/session.h"

#include <nlohmann/json_fwd.hpp>

namespace vp::app
{

// What a rank holds and has used: parts, cells, bytes of layers, memory and processor time.
nlohmann::json resourcesOf(const session::Session& session);

// Puts the documents of all ranks together, and adds "ranks": what depends on how the parts were dealt out. All ranks
// of the session's team call it; the first one gets the whole.
nlohmann::json ofTeam(const session::Session& session, nlohmann::json own);

} // namespace vp::app
