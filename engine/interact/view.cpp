#include "interact/view.h"

#include <cmath>
#include <numbers>

namespace vp::interact
{

Ray rayOf(const View& view, const glm::dvec2& pixel)
{
	return {view.camera.position, view.camera.ray(pixel, view.frame)};
}

double depthOf(const View& view, const Vec3& point)
{
	return glm::dot(point - view.camera.position, view.camera.forward());
}

std::optional<glm::dvec2> pixelOf(const View& view, const Vec3& point)
{
	if (depthOf(view, point) < view.camera.near)
		return std::nullopt;
	return view.camera.project(point, view.frame);
}

double pixelsPerLength(const View& view, double depth)
{
	const double half_field = 0.5 * view.camera.vertical_field * std::numbers::pi / 180.0;
	return 0.5 * view.frame.height / (std::tan(half_field) * depth);
}

std::optional<std::array<glm::dvec2, 2>> seenSegment(const View& view, const Vec3& a, const Vec3& b)
{
	// A little beyond it, so that rounding does not put a clipped end behind.
	const double least = (1.0 + 1e-9) * view.camera.near;
	const double depth_a = depthOf(view, a);
	const double depth_b = depthOf(view, b);
	if (depth_a < least && depth_b < least)
		return std::nullopt;
	const auto end = [&](const Vec3& from, double depth, const Vec3& to, double other)
	{ return depth >= least ? from : from + (least - depth) / (other - depth) * (to - from); };
	return std::array{view.camera.project(end(a, depth_a, b, depth_b), view.frame),
	                  view.camera.project(end(b, depth_b, a, depth_a), view.frame)};
}

std::optional<double> depthOnPlane(const Ray& ray, const Vec3& through, const Vec3& normal)
{
	const double depth = glm::dot(through - ray.from, normal) / glm::dot(ray.along, normal);
	if (!std::isfinite(depth) || depth <= 0.0)
		return std::nullopt;
	return depth;
}

} // namespace vp::interact
