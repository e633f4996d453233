#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/block.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vp::find
{

// Knows which cells are queued without a list over the grid, as the paper suggests: it searches the queue itself. The
// queue is split by the octants about the seed cell, and by generations. A neighbor of a cell of G(k) is in G(k-1),
// G(k) or G(k+1), because faces lead both ways; earlier cells are forgotten. (The paper marks faces instead, and so
// needs no G(k-1).) The search begins at the end of the next generation, where a neighbor most likely is.
//
// Memory depends on the widest generations, and time on a linear search. Use it for few cells, or with little memory.
class OctantQueue
{
public:
	// seed: any cell of the block; its first point is the center of the octants.
	OctantQueue(const grid::Block& block, CellId seed) : block_(&block), center_(placeOf(seed)) {}

	// Returns true if the cell is not among the last three generations. It then belongs to the next one.
	bool mark(CellId cell);
	// From now on, marked cells belong to the next generation.
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
