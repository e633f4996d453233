#include "grid/link/lattice_axes.h"

#include "base/huge_vector.h"
#include "base/parallel_for.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <memory>

namespace vp::grid
{

namespace
{

// The mean edge along each axis, times their number, of some thousand places that are spread over the grid.
Vec3 meanEdges(const CurvilinearGrid& grid)
{
	constexpr std::size_t kSamples = 20011;
	const std::size_t step = std::max<std::size_t>(1, grid.cellCount() / kSamples);
	Vec3 sums(0.0);
	for (std::size_t c = 0; c < grid.cellCount(); c += step)
	{
		const auto [i, j, k] = grid.cellIndex(static_cast<CellId>(c));
		const Vec3 at = grid.pointAt(i, j, k);
		sums += Vec3(glm::length(grid.pointAt(i + 1, j, k) - at), glm::length(grid.pointAt(i, j + 1, k) - at),
		             glm::length(grid.pointAt(i, j, k + 1) - at));
	}
	return sums;
}

template <class Number>
Points turned(const CurvilinearGrid& grid, const Number* from, const std::array<std::uint32_t, 3>& points,
              const std::array<std::size_t, 3>& strides)
{
	const auto numbers = std::make_shared<HugeVector<Number>>(3 * grid.pointCount());
	parallelFor(tbb::blocked_range<std::size_t>(0, std::size_t(points[1]) * points[2]),
	            [&](const auto& range)
	            {
		            for (std::size_t row = range.begin(); row < range.end(); ++row)
		            {
			            const Number* at = from + 3 * (row % points[1] * strides[1] + row / points[1] * strides[2]);
			            Number* to = numbers->data() + 3 * row * points[0];
			            for (std::uint32_t i = 0; i < points[0]; ++i, at += 3 * strides[0], to += 3)
				            std::copy_n(at, 3, to);
		            }
	            });
	return Points(Array<Number>(numbers, numbers->data(), numbers->size()));
}

} // namespace

CurvilinearGrid withShortestEdgesFirst(CurvilinearGrid grid)
{
	constexpr double kWorth = 1.25; // edges along i longer than the shortest by this make copying pay
	if (grid.cellCount() == 0)
		return grid;
	const Vec3 edges = meanEdges(grid);
	const int first = edges.y < edges.x ? (edges.z < edges.y ? 2 : 1) : (edges.z < edges.x ? 2 : 0);
	if (!(edges[first] * kWorth < edges.x))
		return grid;
	std::array<std::uint32_t, 3> points{};
	std::array<std::uint8_t, 3> axes{};
	std::array<std::size_t, 3> strides{};
	const std::array<std::size_t, 3> all_strides = {1, grid.points()[0],
	                                                std::size_t(grid.points()[0]) * grid.points()[1]};
	for (int a = 0; a < 3; ++a)
	{
		const int axis = (first + a) % 3;
		points[a] = grid.points()[axis];
		axes[a] = grid.axes()[axis];
		strides[a] = all_strides[axis];
	}
	const Points& old = grid.coordinates();
	return CurvilinearGrid(points,
	                       old.isDouble() ? turned(grid, old.doubles(), points, strides)
	                                      : turned(grid, old.floats(), points, strides),
	                       axes);
}

} // namespace vp::grid
