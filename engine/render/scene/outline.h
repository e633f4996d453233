#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <array>
#include <string_view>
#include <vector>

namespace vp::render
{

struct Segment
{
	Vec3 a;
	Vec3 b;
};

// Returns one of the eight corners. Bit 0 of i is the high end of x, bit 1 of y, bit 2 of z.
Vec3 corner(const Box& box, int i);

// The lines that show where a sheet lies in the grid.
enum class Outline
{
	none,
	box,  // the twelve curved edges of a curvilinear block, the bounds of any other
	edges // where boundary faces meet at more than 30 degrees, or other than in pairs
};

// The points along the twelve edges of a curvilinear grid: four along i, then along j, then along k. Of each four, bit
// 0 is the end of the next axis, and bit 1 the end of the one behind that.
using EdgeCurves = std::array<std::vector<Vec3>, 12>;
EdgeCurves edgeCurves(const grid::CurvilinearGrid& grid);

std::vector<Segment> outlineOf(const grid::BlockSet& blocks, Outline outline);

// Returns points whose hull contains the blocks and lies close around them. A camera fits them into its picture.
std::vector<Vec3> extentOf(const grid::BlockSet& blocks);

} // namespace vp::render
