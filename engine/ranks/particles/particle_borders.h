#pragma once

#include "base/result.h"
#include "ranks/data/share.h"
#include "ranks/team.h"
#include "vectors/elsewhere.h"

#include <optional>
#include <vector>

namespace vp::ranks
{

/// What a rank knows of the blocks of others, for particles that go there.
struct ParticleBorders
{
	vectors::BlockBorders blocks;
	std::vector<int> rank_of; // per block
	std::vector<Box> boxes;   // per rank
	bool hang = false;        // faces of different sizes meet between two ranks
};

/// The same, found when it is asked for first. All ranks ask together, and of blocks that know their neighbors.
class LazyParticleBorders
{
public:
	const ParticleBorders& of(Team& team, const Share& share, const grid::BlockSet& blocks);

private:
	std::optional<ParticleBorders> known_;
};

} // namespace vp::ranks
