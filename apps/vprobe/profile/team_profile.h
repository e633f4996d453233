#pragma once

#include "profile/profile_report.h"

#include <nlohmann/json_fwd.hpp>

namespace vp::app
{

// Brings the measurements of all ranks of the session's team together at the first one. For each plane, the times are
// those of the slowest rank, and cells, polygons and vertices are summed. Memory is the sum over all ranks. Adds
// "ranks": the times and the resources of each rank. All ranks call this; the other ranks get only a part.
nlohmann::json profileOfTeam(const Profile& own);

} // namespace vp::app
