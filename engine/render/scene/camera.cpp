#include "render/scene/camera.h"
#include "base/angle.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>

namespace vp::render
{

Vec3 Camera::forward() const
{
	return glm::normalize(focal_point - position);
}

Vec3 Camera::right() const
{
	const Vec3 f = forward();
	Vec3 r = glm::cross(f, up);
	if (glm::length(r) < 1e-9 * glm::length(up))
		r = glm::cross(f, std::abs(f.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(0.0, 1.0, 0.0));
	return glm::normalize(r);
}

Vec3 Camera::trueUp() const
{
	return glm::cross(right(), forward());
}

glm::dmat4 Camera::view() const
{
	return glm::lookAt(position, focal_point, trueUp());
}

glm::dmat4 Camera::projection(double aspect) const
{
	const double height = std::tan(0.5 * vertical_field * kDegree);
	glm::dmat4 p(0.0);
	p[0][0] = 1.0 / (height * aspect);
	p[1][1] = -1.0 / height;
	p[3][2] = near;
	p[2][3] = -1.0;
	return p;
}

glm::dvec2 Camera::project(const Vec3& point, const Frame& frame) const
{
	const glm::dvec4 clip = projection(frame.width / frame.height) * view() * glm::dvec4(point, 1.0);
	return {(0.5 + 0.5 * clip.x / clip.w) * frame.width, (0.5 + 0.5 * clip.y / clip.w) * frame.height};
}

Vec3 Camera::ray(const glm::dvec2& pixel, const Frame& frame) const
{
	const double height = std::tan(0.5 * vertical_field * kDegree);
	const glm::dvec2 off = (pixel - 0.5 * glm::dvec2(frame.width, frame.height)) * 2.0 / frame.height;
	return forward() + height * (off.x * right() - off.y * trueUp());
}

void Camera::fitNear(std::span<const Vec3> points)
{
	double nearest = std::numeric_limits<double>::infinity();
	double farthest = 0.0;
	const Vec3 f = forward();
	for (const Vec3& p : points)
	{
		const double depth = glm::dot(p - position, f);
		nearest = std::min(nearest, depth);
		farthest = std::max(farthest, depth);
	}
	if (points.empty() || farthest <= 0.0)
		farthest = nearest = glm::length(focal_point - position);
	near = std::max(0.5 * nearest, 1e-4 * farthest);
}

} // namespace vp::render
