#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "ranks/ranks.h"
#include "render/scene/outline.h"

#include <vector>

namespace vp::ranks
{

/// What a picture shows around the sheets.
struct Surroundings
{
	std::vector<render::Segment> outline;
	std::vector<Vec3> extent; // what a fitted camera must show of the blocks
};

/// Of the blocks of a session; with a team, of those of all ranks, as one process that holds them all would have it.
Result<Surroundings> surroundingsOf(const Ranks& ranks, const grid::BlockSet& blocks, render::Outline outline);

} // namespace vp::ranks
