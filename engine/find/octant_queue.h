#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/block.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vp::find
{

// The paper's lean way to know which cells are queued, without a list over the grid: the queue itself is searched. It
// is split by the octants about the seed cell, and by generations: a neighbor of a cell of G(k) is in G(k-1), G(k) or
// G(k+1), since faces lead both ways; the cells before are forgotten. (The paper marks faces instead and so can do
// without G(k-1).) The search begins at the end of the next generation, where a neighbor is most likely to be.
//
// Memory follows the widest generations, time is that of a linear search: for few cells, or little memory.
class OctantQueue
{
public:
	// seed: whose first point divides space; any cell of the block.
	OctantQueue(const grid::Block& block, CellId seed) : block_(&block), center_(placeOf(seed)) {}

	// True when the cell is not among the last three generations; it then belongs to the next.
	bool mark(CellId cell);
	// What is marked from here on belongs to the generation after the one before.
	void beginGeneration();

	std::size_t bytes() const;

private:
	using Generation = std::array<std::vector<CellId>, 8>; // by octants

	Vec3 placeOf(CellId cell) const;

	const grid::Block* block_;
	Vec3 center_;
	std::array<Generation, 3> generations_; // the next one first
};

} // namespace vp::find
