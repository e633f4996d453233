#include "surface/plane.h"

#include <cassert>

namespace vp::surface
{

Plane::Plane(const Vec3& origin, const Vec3& normal) : origin_(origin)
{
	// Scaled by the largest component first: the length of a very long or very short normal neither overflows nor
	// vanishes.
	const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
	assert(largest > 0.0);
	normal_ = glm::normalize(normal / largest);
	const double first = normal_.x != 0.0 ? normal_.x : normal_.y != 0.0 ? normal_.y : normal_.z;
	if (first < 0.0)
		normal_ = -normal_;
}

} // namespace vp::surface
