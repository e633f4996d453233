#include "grid/farthest_points.h"

#include "base/parallel_for.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>

#include <algorithm>
#include <tuple>

namespace vp::grid
{

namespace
{

constexpr int kBins = 32; // along each side of a cube about the middle

bool liesWithin(const Box& box, const Vec3& point)
{
	return glm::all(glm::greaterThanEqual(point, box.lo)) && glm::all(glm::lessThanEqual(point, box.hi));
}

} // namespace

FarthestPoints::FarthestPoints(const Vec3& middle) : middle_(middle), bins_(6 * kBins * kBins) {}

void FarthestPoints::Farthest::include(double distance, const Vec3& p)
{
	// If points are equally far away, any one will do, but it must always be the same one.
	if (std::tie(square, point.x, point.y, point.z) < std::tie(distance, p.x, p.y, p.z))
		*this = {distance, p};
}

// Returns the bin in which the ray from the middle leaves a cube about it.
std::size_t FarthestPoints::binOf(const Vec3& way) const
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

void FarthestPoints::include(const Box& box, std::size_t count, const std::function<Vec3(std::size_t)>& point)
{
	tbb::combinable<std::vector<Farthest>> found([this] { return std::vector<Farthest>(bins_.size()); });
	tracedFor(tbb::blocked_range<std::size_t>(0, count, 65536),
	          [&](const tbb::blocked_range<std::size_t>& range)
	          {
		          std::vector<Farthest>& mine = found.local();
		          for (std::size_t i = range.begin(); i < range.end(); ++i)
		          {
			          const Vec3 p = point(i);
			          const Vec3 way = p - middle_;
			          if (way != Vec3(0.0) && liesWithin(box, p))
				          mine[binOf(way)].include(glm::dot(way, way), p);
		          }
	          });
	found.combine_each(
	    [&](const std::vector<Farthest>& some)
	    {
		    for (std::size_t bin = 0; bin < bins_.size(); ++bin)
			    if (some[bin].square >= 0.0)
				    bins_[bin].include(some[bin].square, some[bin].point);
	    });
}

std::vector<Vec3> FarthestPoints::points() const
{
	std::vector<Vec3> points;
	for (const Farthest& farthest : bins_)
		if (farthest.square >= 0.0)
			points.push_back(farthest.point);
	if (points.empty())
		points.push_back(middle_);
	return points;
}

} // namespace vp::grid
