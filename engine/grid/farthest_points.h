#pragma once

#include "base/vec.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace vp::grid
{

/// Finds the farthest point from a middle in each of some 6000 directions. Their hull differs from that of all points
/// by less than a picture shows. The same points come out for any number of threads, and of points that came out of
/// others.
class FarthestPoints
{
public:
	explicit FarthestPoints(const Vec3& middle);

	/// Includes point(0) to point(count - 1), on all cores, but not those outside of a box: points of no cell may lie
	/// anywhere.
	void include(const Box& box, std::size_t count, const std::function<Vec3(std::size_t)>& point);

	/// Returns the middle alone if there are no others.
	std::vector<Vec3> points() const;

private:
	struct Farthest
	{
		double square = -1.0; // square of its distance
		Vec3 point;

		void include(double distance, const Vec3& p);
	};

	std::size_t binOf(const Vec3& way) const;

	Vec3 middle_;
	std::vector<Farthest> bins_;
};

} // namespace vp::grid
