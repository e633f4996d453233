#pragma once

#include "grid/block.h"

#include <cstddef>

namespace vp::grid
{

// The memory of a block set in bytes: what was read, and what was built to find cells.
struct Memory
{
	std::size_t geometry = 0; // coordinates, and the points of cells
	std::size_t arrays = 0;
	std::size_t adjacency = 0; // neighbors, and the source's numbers of cells and points
	std::size_t boundary = 0;  // index of boundary faces, vantage points, patches
	std::size_t folds = 0;     // cells where the grid may be folded
	std::size_t trees = 0;     // block trees and places of cells, if somebody asked for them
	std::size_t seams = 0;

	std::size_t read() const { return geometry + arrays; }
	std::size_t built() const { return adjacency + boundary + folds + trees + seams; }
};

// Do not call this while something is being built.
Memory memoryOf(const BlockSet& blocks);

} // namespace vp::grid
