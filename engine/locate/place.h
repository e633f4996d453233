#pragma once

#include "grid/block.h"
#include "locate/interpolate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::locate
{

// A cell that holds a point, and what its points contribute there.
struct Place
{
	std::uint32_t block = 0;
	CellId cell = kNoCell;
	CellWeights weights{};

	bool found() const { return cell != kNoCell; }
};

// Finds the cells of points that mostly lie near each other. Blocks are asked in their order. A point that several
// cells of a block hold, as on a face, belongs to the one that the file lists first, whatever was asked before. Each
// search is a fence hop from the last cell; the block tree decides where that finds none, or one that does not hold the
// point, as happens where faces are warped. Not thread safe; refers to the blocks.
class PlaceFinder
{
public:
	explicit PlaceFinder(const grid::BlockSet& blocks);

	// Valid until the next call.
	const Place& find(const Vec3& point);

	// In one block and without a hop: for points that mostly lie outside of it, where hops would wander.
	const Place& findByTree(std::uint32_t block, const Vec3& point);

	// The same in time that does not grow with the block's cells, in cells behind its boundary: at least in those whose
	// boundary face's box is no farther than `reach`. Not in the cell `besides`.
	const Place& findAtBoundary(std::uint32_t block, const Vec3& point, double reach, CellId besides);

private:
	bool findIn(std::uint32_t block, const Vec3& point);
	void weigh(CellId cell, const Vec3& point);
	void takeFirstOfThoseAround(const Vec3& point);
	void searchTree(const Vec3& point);

	const grid::BlockSet& blocks_;
	std::vector<CellId> last_; // found in each block
	Place place_;
};

} // namespace vp::locate
