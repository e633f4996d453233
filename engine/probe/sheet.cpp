#include "probe/sheet.h"

#include <array>

namespace vp::probe
{

namespace
{

// Of any length but zero. Scaled by the largest component first: the square of a very long or very short one is no
// number.
Vec3 unit(const Vec3& v)
{
	const Vec3 magnitude = glm::abs(v);
	return glm::normalize(v / std::max({magnitude.x, magnitude.y, magnitude.z}));
}

} // namespace

Sheet makeSheet(const Vec3& origin, const Vec3& normal, const Vec3& up)
{
	Sheet sheet;
	sheet.origin = origin;
	sheet.normal = unit(normal);
	for (const Vec3& candidate : std::array<Vec3, 3>{up, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}})
	{
		if (candidate == Vec3(0.0))
			continue;
		const Vec3 direction = unit(candidate);
		const Vec3 flat = direction - glm::dot(direction, sheet.normal) * sheet.normal;
		if (glm::length(flat) > 1e-6)
		{
			sheet.up = glm::normalize(flat);
			break;
		}
	}
	return sheet;
}

} // namespace vp::probe
