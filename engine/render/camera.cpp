#include "render/camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vp::render
{

namespace
{

constexpr double kDegree = std::numbers::pi / 180.0;

// From the scene to the eye.
Vec3 fromAngles(double azimuth, double elevation)
{
	return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

struct View
{
	Vec3 direction;
	Vec3 up;
};

// Turned from the sheet's normal by 30 degrees of azimuth and 20 of elevation about an upright z axis: the sheet is seen almost
// face on, the outline's depth still shows. A level sheet is looked down on at 45 degrees, x to the right.
View obliqueView(const Vec3& sheet_normal)
{
	// The plane has no front: the eye stays above it.
	const Vec3 n = sheet_normal.z < 0.0 ? -sheet_normal : sheet_normal;
	const bool level = std::hypot(n.x, n.y) < 0.02;
	const double azimuth = level ? -60.0 * kDegree : std::atan2(n.y, n.x) + 30.0 * kDegree;
	const double elevation = std::min(std::asin(std::min(n.z, 1.0)) + 20.0 * kDegree, 45.0 * kDegree);
	return {fromAngles(azimuth, elevation), {0.0, 0.0, 1.0}};
}

View chosenView(const CameraChoice& choice, const probe::Sheet* sheet)
{
	switch (choice.kind)
	{
	case CameraChoice::Kind::direction:
		return {choice.direction, choice.up};
	case CameraChoice::Kind::sheet:
		if (sheet)
			return {sheet->normal, sheet->up};
		break;
	case CameraChoice::Kind::automatic:
		if (sheet)
			return obliqueView(sheet->normal);
		break;
	case CameraChoice::Kind::fixed:
		break;
	}
	return obliqueView({0.0, 0.0, 1.0});
}

// One axis of the picture. A point at (side, depth) in the camera's axes stays within the slopes [lo, hi] of the picture when
// the eye (e, d) satisfies  side - e >= lo (depth - d)  and  side - e <= hi (depth - d).
struct AxisFit
{
	double lo;
	double hi;
	double least = std::numeric_limits<double>::infinity();
	double most = -std::numeric_limits<double>::infinity();

	void include(double side, double depth)
	{
		least = std::min(least, side - lo * depth);
		most = std::max(most, side - hi * depth);
	}
	double farthestEye() const { return (least - most) / (hi - lo); }
	double leastEye(double depth) const { return most + hi * depth; }
	double mostEye(double depth) const { return least + lo * depth; }
};

// Moves the camera, which looks at `centre` from afar, until its picture of the points fills the pixels from lo to hi.
void fit(Camera& camera, const Vec3& centre, double size, std::span<const Vec3> points, const Frame& frame, const glm::dvec2& lo,
		 const glm::dvec2& hi)
{
	const Vec3 right = camera.right();
	const Vec3 up = camera.trueUp();
	const Vec3 forward = camera.forward();
	const double tangent = std::tan(0.5 * camera.vertical_field * kDegree);
	const double wide = tangent * frame.width / frame.height;
	const auto slope = [](double pixel, double extent) { return 2.0 * pixel / extent - 1.0; };
	AxisFit x{wide * slope(lo.x, frame.width), wide * slope(hi.x, frame.width)};
	AxisFit y{-tangent * slope(hi.y, frame.height), -tangent * slope(lo.y, frame.height)};
	double nearest = 0.0;
	double farthest = 0.0;
	for (const Vec3& p : points)
	{
		const Vec3 from_centre = p - centre;
		const double depth = glm::dot(from_centre, forward);
		x.include(glm::dot(from_centre, right), depth);
		y.include(glm::dot(from_centre, up), depth);
		nearest = std::min(nearest, depth);
		farthest = std::max(farthest, depth);
	}
	// The eye stays outside the scene even where its picture would leave room to come closer (a flat scene seen edge on).
	const double eye_depth = std::min({x.farthestEye(), y.farthestEye(), nearest - 1e-3 * size});
	const glm::dvec2 least{x.leastEye(eye_depth), y.leastEye(eye_depth)};
	const glm::dvec2 most{x.mostEye(eye_depth), y.mostEye(eye_depth)};
	glm::dvec2 eye = 0.5 * (least + most);
	// Across what the picture does not fill, as much room on either side. Perspective makes this a few steps.
	for (int step = 0; step < 8; ++step)
	{
		glm::dvec2 from(std::numeric_limits<double>::infinity());
		glm::dvec2 to(-std::numeric_limits<double>::infinity());
		for (const Vec3& p : points)
		{
			const glm::dvec2 side{glm::dot(p - centre, right), glm::dot(p - centre, up)};
			const glm::dvec2 slopes = (side - eye) / (glm::dot(p - centre, forward) - eye_depth);
			from = glm::min(from, slopes);
			to = glm::max(to, slopes);
		}
		const glm::dvec2 off = 0.5 * (from + to - glm::dvec2(x.lo + x.hi, y.lo + y.hi));
		eye = glm::clamp(eye + off * (nearest - eye_depth), glm::min(least, most), glm::max(least, most));
	}
	camera.position = centre + eye.x * right + eye.y * up + eye_depth * forward;
	camera.focal_point = camera.position + (0.5 * (nearest + farthest) - eye_depth) * forward;
	camera.fitNear(points);
}

// Whether a line parts the picture of the points' hull from the frame's corner.
bool staysOffCorner(const Camera& camera, std::span<const Vec3> points, const Frame& frame)
{
	constexpr int kDirections = 16;
	std::array<double, kDirections + 1> nearest;
	nearest.fill(-std::numeric_limits<double>::infinity());
	const glm::dmat4 matrix = camera.projection(frame.width / frame.height) * camera.view();
	for (const Vec3& p : points)
	{
		const glm::dvec4 clip = matrix * glm::dvec4(p, 1.0);
		const double x = (0.5 + 0.5 * clip.x / clip.w) * frame.width - frame.corner->x;
		const double y = (0.5 + 0.5 * clip.y / clip.w) * frame.height - frame.corner->y;
		for (int i = 0; i <= kDirections; ++i)
		{
			const double angle = 0.5 * std::numbers::pi * i / kDirections;
			nearest[i] = std::max(nearest[i], -std::cos(angle) * x + std::sin(angle) * y);
		}
	}
	return std::any_of(nearest.begin(), nearest.end(), [](double reach) { return reach <= 0.0; });
}

} // namespace

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

Camera makeCamera(const CameraChoice& choice, const probe::Sheet* sheet, std::span<const Vec3> points, const Frame& frame)
{
	if (choice.kind == CameraChoice::Kind::fixed)
	{
		Camera camera = choice.camera;
		camera.fitNear(points);
		return camera;
	}
	const View view = chosenView(choice, sheet);
	Box bounds;
	for (const Vec3& p : points)
		bounds.include(p);
	const Vec3 centre = bounds.empty() ? Vec3(0.0) : bounds.centre();
	const double size = bounds.diagonal() > 0.0 ? bounds.diagonal() : 1.0;

	Camera camera;
	camera.focal_point = centre;
	camera.position = centre + size * glm::normalize(view.direction);
	camera.up = view.up;
	camera.up = camera.trueUp();
	if (bounds.diagonal() == 0.0)
		return camera;
	const auto fits = [&](const glm::dvec2& lo, const glm::dvec2& hi)
	{
		Camera fitted = camera;
		fit(fitted, centre, size, points, frame, lo, hi);
		return fitted;
	};
	const Camera whole = fits(frame.free_lo, frame.free_hi);
	if (!frame.corner || staysOffCorner(whole, points, frame))
		return whole;
	const Camera beside = fits({frame.corner->x, frame.free_lo.y}, frame.free_hi);
	const Camera above = fits(frame.free_lo, {frame.free_hi.x, frame.corner->y});
	const auto distance = [&centre](const Camera& c) { return glm::dot(centre - c.position, c.forward()); };
	return distance(beside) < distance(above) ? beside : above;
}

} // namespace vp::render
