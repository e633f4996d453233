#pragma once

#include "session/session.h"

namespace vp::session
{

// An array of the session's blocks at each of its inputs' times, read when it is asked for; blocks and timeline outlive
// it. An input error where there is one time only; where the grid moves, loading is one.
Result<vectors::StoredVectors> storedVectors(const Session& session, const grid::FieldChoice& array);

} // namespace vp::session
