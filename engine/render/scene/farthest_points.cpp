#include "render/scene/farthest_points.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vp::render
{

namespace
{

constexpr int kBins = 32; // along each side of a cube about the middle

struct Farthest
{
	double square = -1.0; // square of its distance
	Vec3 point;

	void include(double distance, const Vec3& p)
	{
		// If points are equally far away, any one will do, but it must always be the same one.
		if (std::tie(square, point.x, point.y, point.z) < std::tie(distance, p.x, p.y, p.z))
			*this = {distance, p};
	}
};

using Bins = std::vector<Farthest>;

/// Returns the bin in which the ray from the middle leaves a cube about it.
std::size_t binOf(const Vec3& way)
{
	const Vec3 length = glm::abs(way);
	const int axis = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
	const auto along = [&](int other)
	{
		const double at = 0.5 * (way[other] / length[axis] + 1.0); // 0 to 1
		return static_cast<std::size_t>(std::clamp(static_cast<int>(at * kBins), 0, kBins - 1));
	};
	const std::size_t side = 2 * static_cast<std::size_t>(axis) + (way[axis] > 0.0 ? 1 : 0);
	return (side * kBins + along((axis + 1) % 3)) * kBins + along((axis + 2) % 3);
}

bool holds(const Box& box, const Vec3& point)
{
	return glm::all(glm::greaterThanEqual(point, box.lo)) && glm::all(glm::lessThanEqual(point, box.hi));
}

} // namespace

std::vector<Vec3> farthestPoints(const grid::BlockSet& blocks)
{
	Box bounds;
	for (const grid::Block& block : blocks.blocks)
		if (std::holds_alternative<grid::UnstructuredGrid>(block.grid))
			bounds.include(block.bounds);
	if (bounds.empty())
		return {};
	const Vec3 middle = bounds.center();
	const auto emptyBins = [] { return Bins(6 * kBins * kBins); };
	tbb::combinable<Bins> found(emptyBins);
	for (const grid::Block& block : blocks.blocks)
		if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
			tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid->usedPointCount(), 65536),
			                  [&](const tbb::blocked_range<std::size_t>& range)
			                  {
				                  Bins& mine = found.local();
				                  for (std::size_t p = range.begin(); p < range.end(); ++p)
				                  {
					                  const Vec3 point = grid->point(static_cast<PointId>(p));
					                  const Vec3 way = point - middle;
					                  // Points of no cell may lie anywhere.
					                  if (way != Vec3(0.0) && holds(block.bounds, point))
						                  mine[binOf(way)].include(glm::dot(way, way), point);
				                  }
			                  });
	Bins all = emptyBins();
	found.combine_each(
	    [&](const Bins& some)
	    {
		    for (std::size_t i = 0; i < all.size(); ++i)
			    if (some[i].square >= 0.0)
				    all[i].include(some[i].square, some[i].point);
	    });
	std::vector<Vec3> points;
	for (const Farthest& farthest : all)
		if (farthest.square >= 0.0)
			points.push_back(farthest.point);
	if (points.empty()) // all points are the middle
		points.push_back(middle);
	return points;
}

} // namespace vp::render
