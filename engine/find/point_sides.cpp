#include "find/point_sides.h"

#include "surface/sign_filter.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

namespace vp::find
{

namespace
{

std::uint8_t sideOf(double height)
{
	return static_cast<std::uint8_t>((height >= 0.0 ? kPositive : kNegative) | (height == 0.0 ? kInSurface : 0));
}

/// The sides of four points. The index has a bit for each point that is positive.
constexpr std::array<std::array<std::uint8_t, 4>, 16> kSidesOfFour = []
{
	std::array<std::array<std::uint8_t, 4>, 16> sides{};
	for (unsigned bits = 0; bits < 16; ++bits)
		for (unsigned v = 0; v < 4; ++v)
			sides[bits][v] = bits >> v & 1 ? kPositive : kNegative;
	return sides;
}();

/// Four at a time in float, where that is certain. Beyond the bounds nothing is.
template <class Number>
void takeSidesOf(const Number* xyz, const surface::Plane& plane, const Box& bounds, std::size_t begin, std::size_t end,
                 std::uint8_t* sides)
{
	const surface::SignFilter filter(plane, bounds);
	for (std::size_t p = begin; p < end;)
	{
		const std::size_t last = std::min<std::size_t>(p + 4, end);
		const unsigned bits =
		    last - p == 4 ? filter.four(surface::loadFour(xyz + 3 * p)) : surface::SignFilter::kInDoubt;
		if (bits != surface::SignFilter::kInDoubt) [[likely]]
			std::ranges::copy(kSidesOfFour[bits], sides + p);
		else
			for (std::size_t i = p; i < last; ++i)
				sides[i] = sideOf(plane.signedDistance({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}));
		p = last;
	}
}

} // namespace

void takeSides(const grid::UnstructuredGrid& grid, const surface::Plane& plane, const Box& bounds, std::size_t begin,
               std::size_t end, std::uint8_t* sides)
{
	const grid::Points& points = grid.coordinates();
	if (points.isDouble())
		takeSidesOf(points.doubles(), plane, bounds, begin, end, sides);
	else
		takeSidesOf(points.floats(), plane, bounds, begin, end, sides);
}

void takeSides(const grid::UnstructuredGrid& grid, const surface::Plane& plane, std::span<const PointId> points,
               std::uint8_t* sides)
{
	for (const PointId p : points)
		std::atomic_ref(sides[p]).store(sideOf(plane.signedDistance(grid.point(p))), std::memory_order_relaxed);
}

void takeSides(const grid::UnstructuredGrid& grid, const surface::BlockSurface& surface,
               std::span<const PointId> points, std::uint8_t* sides)
{
	constexpr std::size_t kMax = surface::BlockSurface::kMaxPoints;
	std::array<double, kMax> heights;
	for (; !points.empty(); points = points.subspan(std::min(kMax, points.size())))
	{
		const std::span<const PointId> some = points.first(std::min(kMax, points.size()));
		surface.heights(grid, some, heights.data());
		for (std::size_t i = 0; i < some.size(); ++i)
			std::atomic_ref(sides[some[i]]).store(sideOf(heights[i]), std::memory_order_relaxed);
	}
}

void takeSides(const grid::UnstructuredGrid& grid, const surface::BlockSurface& surface, const Box&, std::size_t begin,
               std::size_t end, std::uint8_t* sides)
{
	constexpr std::size_t kMax = surface::BlockSurface::kMaxPoints;
	std::array<PointId, kMax> ids;
	std::array<double, kMax> heights;
	for (; begin < end; begin += kMax)
	{
		const std::size_t count = std::min(kMax, end - begin);
		std::iota(ids.begin(), ids.end(), static_cast<PointId>(begin));
		surface.heights(grid, {ids.data(), count}, heights.data());
		for (std::size_t i = 0; i < count; ++i)
			sides[begin + i] = sideOf(heights[i]);
	}
}

} // namespace vp::find
