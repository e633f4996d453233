#pragma once

#include "contour/contour_parts.h"
#include "grid/block.h"
#include "ranks/team.h"

#include <cstdint>
#include <vector>

namespace vp::ranks
{

/// Which groups of a contour's cells are a part of it.
struct ReachedGroups
{
	std::vector<std::uint8_t> reached; // per own group: 1 if it is connected with what grows from the sheet
	bool hangs = false; // a face of one rank meets several smaller ones of another: then nothing here holds
};

/// Joins the groups of all ranks where faces lie on each other, but for rounding: as a traversal in one process crosses
/// them. boxes: boxesOf() the team.
ReachedGroups reachedGroups(Team& team, const std::vector<Box>& boxes, const grid::BlockSet& blocks,
                            const contour::ContourParts& parts);

} // namespace vp::ranks
