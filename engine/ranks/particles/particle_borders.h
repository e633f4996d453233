#pragma once

#include "base/result.h"
#include "ranks/ranks.h"
#include "vectors/elsewhere.h"

#include <vector>

namespace vp::ranks
{

/// The facts about the blocks of other ranks that a rank knows, for particles that move there.
struct ParticleBorders
{
	vectors::BlockBorders blocks;
	std::vector<int> rank_of; // per block
	std::vector<Box> boxes;   // per rank
	bool hang = false;        // faces of different sizes meet between two ranks
};

/// The same, found when it is asked for first, and known to the ranks from then on. All ranks ask together, and of
/// blocks that know their neighbors. There must be several.
const ParticleBorders& particleBorders(const Ranks& ranks, const grid::BlockSet& blocks);

} // namespace vp::ranks
