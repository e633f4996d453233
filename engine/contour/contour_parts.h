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
	std::uint32_t group; // group of the face's cell
};

// The part of a contour that one of several processes finds in its blocks: groups of cells that are connected across
// faces in the box. Group 0 grows from the sheet. Each other group has a way out.
struct ContourParts
{
	double value = 0.0;
	std::vector<surface::BlockSurface> surfaces;    // per block
	std::vector<find::CellCut> cuts;                // per block; without generations
	std::vector<std::vector<std::uint32_t>> groups; // per block: the group of each cell of its cut
	std::uint32_t group_count = 1;
	std::vector<WayOut> ways_out;
	std::size_t seeds = 0; // number of seeds of group 0
	std::size_t generations = 0;
};

// Drops the cells of all groups that are not kept. kept: per group.
void keepGroups(const std::vector<std::uint8_t>& kept, ContourParts& parts);

} // namespace vp::contour
