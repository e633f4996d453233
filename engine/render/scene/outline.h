#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <string_view>
#include <vector>

namespace vp::render
{

struct Segment
{
	Vec3 a;
	Vec3 b;
};

// One of eight: bit 0 of i takes the high end of x, bit 1 of y, bit 2 of z.
Vec3 corner(const Box& box, int i);

// The lines that tell where in the grid a sheet lies.
enum class Outline
{
	none,
	box,  // of a curvilinear block the twelve curved edges of its index box, of any other its bounds
	edges // where boundary faces meet at more than 30 degrees, or other than in pairs
};

std::vector<Segment> outlineOf(const grid::BlockSet& blocks, Outline outline);

// Points whose hull holds the blocks, close around them: what a camera fits into its picture.
std::vector<Vec3> extentOf(const grid::BlockSet& blocks);

} // namespace vp::render
