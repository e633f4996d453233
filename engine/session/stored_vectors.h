#pragma once

#include "session/session.h"

namespace vp::session
{

// Returns an array of the blocks at every time of the inputs. Values are read when they are needed. Blocks and timeline
// outlive it. An input with only one time is an input error; a grid that moves is an input error when values are read.
Result<vectors::StoredVectors> storedVectors(const Session& session, const grid::FieldChoice& array);

} // namespace vp::session
