#pragma once

#include "base/two_doubles.h"
#include "base/vec.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace vp::mesh
{

// Which way polygons of different vertices in a plane run, as Facing (tidy_polygons.h) tells it of any, for a loop over
// many. They have up to kCorners vertices, 4 or 6. So many are given: places behind the last one repeat the first.
template <int kCorners>
class FanSense
{
public:
	// extent: of a box with all positions.
	FanSense(const Vec3& normal, const Vec3& extent, const Vec3* positions) : clear_(kThin * glm::dot(extent, extent))
	{
		const Vec3 size = glm::abs(normal);
		const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
		u_ = reinterpret_cast<const double*>(positions) + (axis + 1) % 3;
		v_ = reinterpret_cast<const double*>(positions) + (axis + 2) % 3;
		if (normal[axis] < 0.0) // seen from the other side
			std::swap(u_, v_);
	}

	// Twice the area along the axis that is nearest to the normal, above 0 if the polygon runs counter-clockwise.
	double areaOf(const std::uint32_t* fan) const
	{
		// With d from the first corner on: d1 x d2 + d2 x d3 + d3 x d4 + d4 x d5.
		const TwoDoubles first = seen(fan[0]);
		const TwoDoubles third = seen(fan[3]);
		TwoDoubles products = (seen(fan[2]) - first) * swapped(third - seen(fan[1]));
		if constexpr (kCorners == 6)
			products += (seen(fan[4]) - first) * swapped(seen(fan[5]) - third);
		return products[0] - products[1];
	}
	// Returns true if a polygon with this area runs counter-clockwise and is no sliver, whatever its shape. Most are.
	bool isClear(double area) const { return area > clear_; }
	// The area; 0 if tidyPolygons() may have to do with the polygon.
	double checked(double area, const std::uint32_t* fan) const
	{
		double square = 0.0; // squared distance of the farthest corner
		for (int corner = 1; corner < kCorners; ++corner)
		{
			const TwoDoubles way = seen(fan[corner]) - seen(fan[0]);
			square = std::max(square, way[0] * way[0] + way[1] * way[1]);
		}
		return std::abs(area) <= kThin * square ? 0.0 : area;
	}

	// Well above the area that tidyPolygons() treats as zero. Seen along the axis, areas and distances are right within
	// a factor of two.
	static constexpr double kThin = 1e-12;

private:
	static_assert(kCorners == 4 || kCorners == 6);

	TwoDoubles seen(std::uint32_t vertex) const
	{
		return loadTwo(u_ + 3 * std::size_t(vertex), v_ + 3 * std::size_t(vertex));
	}

	const double* u_;
	const double* v_;
	double clear_;
};

} // namespace vp::mesh
