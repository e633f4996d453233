#pragma once

#include <glm/vec2.hpp>

namespace vp
{

// The z component of the cross product: twice the signed area of the triangle 0, a, b.
inline double cross(const glm::dvec2& a, const glm::dvec2& b)
{
	return a.x * b.y - a.y * b.x;
}

} // namespace vp
