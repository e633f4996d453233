#pragma once

#include "grid/block.h"

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace vp::test
{

// A block before it is built, so that it can be moved, shuffled and built again.
struct RawCell
{
	std::uint8_t type; // VTK's; 42: polyhedron
	std::vector<std::int64_t> ids;
	std::vector<std::vector<std::int64_t>> faces; // faces of a polyhedron
};

enum class RawKind
{
	image,
	rectilinear,
	curvilinear,
	cells
};

struct RawBlock
{
	RawKind kind = RawKind::cells;
	std::array<std::uint32_t, 3> points_along{}; // if it is a lattice
	std::vector<Vec3> points;                    // if it is a lattice, in its order
	std::vector<RawCell> cells;                  // if it is not a lattice
	bool floats = false;                         // coordinates kept as floats
};

// A set of grids, and the faults that it may have.
struct RawSet
{
	std::string name;
	std::vector<RawBlock> blocks;
	bool conforming = true;  // cells meet in whole faces, two at most
	bool flat_faces = false; // convex cells, none of them inverted
	bool collapsed = false;  // points drawn together
};

// Finished blocks with the point field "linear" (linearAt()) and the cell field "id", seams matched.
grid::BlockSet build(const RawSet& raw);

// Moves every point; images and rectilinear grids become curvilinear.
template <class Move>
RawSet moved(RawSet raw, Move&& move)
{
	for (RawBlock& block : raw.blocks)
	{
		if (block.kind != RawKind::cells)
			block.kind = RawKind::curvilinear;
		for (Vec3& p : block.points)
			p = move(p);
	}
	return raw;
}

// Unstructured blocks with their cells and points in another order; source cell c of the shuffled block is cell
// order[c] of the other one.
RawBlock shuffled(const RawBlock& raw, std::mt19937& random, std::vector<std::size_t>& order);

} // namespace vp::test
