#pragma once

#include "base/vec.h"

namespace vp::probe
{

// The bounds as seen along a unit direction, from a point: [middle - half, middle + half].
struct Extent
{
	double middle;
	double half;
};

inline Extent extentAlong(const Box& bounds, const Vec3& direction, const Vec3& from)
{
	return {glm::dot(bounds.center() - from, direction), glm::dot(glm::abs(direction), 0.5 * bounds.size())};
}

} // namespace vp::probe
