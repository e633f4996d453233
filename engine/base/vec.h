#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <limits>

namespace vp
{

// Positions are computed in double; float is for what goes to the GPU.
using Vec3 = glm::dvec3;
using Vec3f = glm::vec3;

// An axis-aligned box. Empty (lo > hi) until a point is included.
struct Box
{
	Vec3 lo{std::numeric_limits<double>::infinity()};
	Vec3 hi{-std::numeric_limits<double>::infinity()};

	void include(const Vec3& p)
	{
		lo = glm::min(lo, p);
		hi = glm::max(hi, p);
	}
	void include(const Box& b)
	{
		lo = glm::min(lo, b.lo);
		hi = glm::max(hi, b.hi);
	}
	bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
	Vec3 center() const { return 0.5 * (lo + hi); }
	Vec3 size() const { return hi - lo; }
	double diagonal() const { return empty() ? 0.0 : glm::length(size()); }
};

} // namespace vp
