#pragma once

#include "grid/block.h"
#include "ranks/data/share.h"
#include "ranks/message.h"

#include <cstddef>

namespace vp::ranks
{

/// The facts about a block that ranks know although they do not hold it.
struct DescribedBlock
{
	std::size_t kind = 0;
	Box bounds;
	Share::Counts counts; // counts for this block alone
	std::size_t whole = 0;
	grid::Block block; // without a grid
};

/// Returns the counts of a block alone, as far as it is here.
Share::Counts countsOf(const grid::Block& block);

/// Puts the facts about a block into a message. whole: the block that one process would have in its place.
void put(MessageWriter& to, const grid::Block& block, std::size_t whole);
DescribedBlock described(MessageReader& from);

/// Returns a block without cells in place of one that another rank holds.
grid::Block standIn(DescribedBlock&& described);

} // namespace vp::ranks
