#pragma once

#include "grid/block.h"
#include "locate/interpolate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::locate
{

// A cell that contains a point, and the weights of the cell's points there.
struct Place
{
	std::uint32_t block = 0;
	CellId cell = kNoCell;
	CellWeights weights{};

	bool found() const { return cell != kNoCell; }
};

// Finds the cells of points that mostly lie near each other. Blocks are asked in their order. If several cells of a
// block contain a point, as on a face, it belongs to the one that the file lists first. Each search is a fence hop from
// the last cell. If the hop finds no cell, or a cell that does not contain the point, as may happen with warped faces,
// the block tree decides. Not thread safe. It refers to the blocks.
class PlaceFinder
{
public:
	explicit PlaceFinder(const grid::BlockSet& blocks);

	// Valid until the next call.
	const Place& find(const Vec3& point);

	// Searches one block without a hop. Use it for points that mostly lie outside the block, where hops would wander.
	const Place& findByTree(std::uint32_t block, const Vec3& point);

	// The same for cells behind the boundary, in time that does not depend on the number of cells. It asks at least the
	// cells whose boundary face has its box within `reach`, but not the cell `besides`.
	const Place& findAtBoundary(std::uint32_t block, const Vec3& point, double reach, CellId besides);

private:
	bool findIn(std::uint32_t block, const Vec3& point);
	void weigh(CellId cell, const Vec3& point);
	void takeFirstOfThoseAround(const Vec3& point);
	void searchTree(const Vec3& point);

	const grid::BlockSet& blocks_;
	std::vector<CellId> last_; // the last cell in each block
	Place place_;
};

} // namespace vp::locate
