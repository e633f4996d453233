#include "probe/sheet.h"

#include <array>

namespace vp::probe
{

Sheet makeSheet(const Vec3& origin, const Vec3& normal, const Vec3& up)
{
	Sheet sheet;
	sheet.origin = origin;
	const Vec3 magnitude = glm::abs(normal);
	sheet.normal = glm::normalize(normal / std::max({magnitude.x, magnitude.y, magnitude.z}));
	for (const Vec3& candidate : std::array<Vec3, 3>{up, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}})
	{
		const Vec3 flat = candidate - glm::dot(candidate, sheet.normal) * sheet.normal;
		if (glm::length(flat) > 1e-6 * glm::length(candidate))
		{
			sheet.up = glm::normalize(flat);
			break;
		}
	}
	return sheet;
}

} // namespace vp::probe
