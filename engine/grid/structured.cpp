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

CurvilinearGrid::CurvilinearGrid(std::array<std::uint32_t, 3> points, Points coordinates,
                                 std::array<std::uint8_t, 3> axes)
    : Lattice(points), points_(std::move(coordinates)), axes_(axes)
{
	assert(points_.size() == pointCount());
	const Lattice source = sourceLattice();
	for (int a = 0; a < 3; ++a)
	{
		std::array<std::uint32_t, 3> next{0, 0, 0};
		next[axes[a]] = 1;
		source_point_strides_[a] = source.pointId(next[0], next[1], next[2]);
		source_cell_strides_[a] = source.cell(next[0], next[1], next[2]);
	}
}

Lattice CurvilinearGrid::sourceLattice() const
{
	std::array<std::uint32_t, 3> source{};
	for (int a = 0; a < 3; ++a)
		source[axes_[a]] = points()[a];
	return Lattice(source);
}

} // namespace vp::grid
