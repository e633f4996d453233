#pragma once

#include "profile/profile_report.h"

#include <nlohmann/json_fwd.hpp>

namespace vp::app
{

// Brings what all ranks of the session's team have measured together at the first one. Of each plane, the slowest
// rank's times count, and the sum of cells, polygons and vertices. Memory is that of all together. Adds "ranks": the
// times and the resources of each. All ranks call it; what others get is a part.
nlohmann::json profileOfTeam(const Profile& own);

} // namespace vp::app
