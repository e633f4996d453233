#include "render/picture_geometry.h"

#include "render/look.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vp::render
{

std::vector<glm::dvec2> samplePattern(int samples)
{
	samples = std::clamp(samples, 1, kMaxSamples);
	// The generator near n / golden ratio without a common factor spreads the lattice well.
	int generator = std::max(1, static_cast<int>(std::lround(samples / std::numbers::phi)));
	while (std::gcd(generator, samples) != 1)
		++generator;
	std::vector<glm::dvec2> pattern;
	for (int i = 0; i < samples; ++i)
		pattern.push_back(
		    {(i + 0.5) / samples - 0.5, (static_cast<long>(i) * generator % samples + 0.5) / samples - 0.5});
	return pattern;
}

glm::dmat4 clipMatrix(const Camera& camera, VkExtent2D extent, const Vec3& centre, const glm::dvec2& jitter)
{
	const glm::dvec2 size(extent.width, extent.height);
	glm::dmat4 shift(1.0);
	shift[3][0] = 2.0 * jitter.x / size.x;
	shift[3][1] = 2.0 * jitter.y / size.y;
	return shift * camera.projection(size.x / size.y) * glm::translate(camera.view(), centre);
}

shared::LayerPush layerPush(const probe::Sheet& sheet, const Camera& camera, VkExtent2D extent,
                            const glm::dvec2& jitter)
{
	const glm::dmat4 clip = clipMatrix(camera, extent, sheet.origin, jitter);
	const glm::dvec4 u = clip * glm::dvec4(sheet.xAxis(), 0.0);
	const glm::dvec4 v = clip * glm::dvec4(sheet.up, 0.0);
	const glm::dvec4 origin = clip[3];
	shared::LayerPush push{};
	for (int i = 0; i < 4; ++i)
	{
		push.u_axis[i] = static_cast<float>(u[i]);
		push.v_axis[i] = static_cast<float>(v[i]);
		push.origin[i] = static_cast<float>(origin[i]);
	}
	return push;
}

std::array<double, 3> planeDepth(const probe::Sheet& sheet, const Camera& camera, VkExtent2D extent)
{
	const Vec3 to_sheet = sheet.origin - camera.position;
	const double distance = glm::dot(sheet.normal, to_sheet);
	if (std::abs(distance) < 1e-12 * glm::length(to_sheet))
		return {0.0, 0.0, 0.0};
	// The point of the plane seen at a pixel is eye + w ray, ray = forward + x right + y up linear in the pixel.
	const double tangent = std::tan(0.5 * camera.vertical_field * std::numbers::pi / 180.0);
	const double right = glm::dot(sheet.normal, camera.right()) * tangent * extent.width / extent.height;
	const double up = glm::dot(sheet.normal, camera.trueUp()) * tangent;
	const double forward = glm::dot(sheet.normal, camera.forward());
	const double scale = camera.near / distance;
	return {scale * right * 2.0 / extent.width, -scale * up * 2.0 / extent.height, scale * (forward - right + up)};
}

} // namespace vp::render
