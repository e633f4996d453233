#include "grid/structured.h"

#include <algorithm>

namespace vp::grid
{

Lattice::Lattice(std::array<std::uint32_t, 3> points) : points_(points)
{
	if (std::ranges::any_of(points, [](std::uint32_t n) { return n < 2; }))
		return;
	cells_ = {points[0] - 1, points[1] - 1, points[2] - 1};
	stride_ = {1, cells_[0], cells_[0] * cells_[1]};
	assert(pointCount() <= kMaxBlockIds);
}

} // namespace vp::grid
