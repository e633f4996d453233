#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "ranks/ranks.h"
#include "render/scene/outline.h"

#include <vector>

namespace vp::ranks
{

/// The surroundings of the sheets that a picture shows.
struct Surroundings
{
	std::vector<render::Segment> outline;
	std::vector<Vec3> extent; // points of the blocks that a fitted camera must show
};

/// Of the blocks of a session; with a team, of those of all ranks, as one process that holds them all would have it.
Result<Surroundings> surroundingsOf(const Ranks& ranks, const grid::BlockSet& blocks, render::Outline outline);

} // namespace vp::ranks
