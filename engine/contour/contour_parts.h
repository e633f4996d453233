#pragma once

#include "find/generations.h"
#include "grid/boundary.h"
#include "surface/curved.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::contour
{

// A boundary face, cut in the box, through which a contour may lead into the blocks of another process.
struct WayOut
{
	std::uint32_t block;
	grid::BoundaryIndex::Face face;
	std::uint32_t group; // of its cell
};

// What one of several processes finds of a contour in its blocks: groups of cells that hang together across faces in
// the box. Group 0 is what grows from the sheet; each of the others has a way out.
struct ContourParts
{
	double value = 0.0;
	std::vector<surface::BlockSurface> surfaces;    // per block
	std::vector<find::CellCut> cuts;                // per block; without generations
	std::vector<std::vector<std::uint32_t>> groups; // per block, of each cell of its cut
	std::uint32_t group_count = 1;
	std::vector<WayOut> ways_out;
	std::size_t seeds = 0; // of group 0
	std::size_t generations = 0;
};

// Drops the cells of all groups but those that are kept. kept: per group.
void keepGroups(const std::vector<std::uint8_t>& kept, ContourParts& parts);

} // namespace vp::contour
