#include "base/angle.h"
#include "render/scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vp::render
{

namespace
{

// From the scene to the eye.
Vec3 directionOfAngles(double azimuth, double elevation)
{
	return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

struct View
{
	Vec3 direction;
	Vec3 up;
};

// Turned from the sheet's normal by 30 degrees of azimuth and 20 of elevation about an upright z axis: the sheet is
// seen almost face on, the outline's depth still shows. A level sheet is looked down on at 45 degrees, x to the right.
// There are two such azimuths; the eye takes the one from which x and y lie more as usual.
View obliqueView(const Vec3& sheet_normal)
{
	// The plane has no front: the eye stays above it.
	const Vec3 n = sheet_normal.z < 0.0 ? -sheet_normal : sheet_normal;
	const bool level = std::hypot(n.x, n.y) < 0.02;
	const double usual = -60.0 * kDegree;
	const double facing = std::atan2(n.y, n.x), turn = 30.0 * kDegree;
	const bool turns_on = std::cos(facing + turn - usual) >= std::cos(facing - turn - usual);
	const double azimuth = level ? usual : facing + (turns_on ? turn : -turn);
	const double elevation = std::min(std::asin(std::min(n.z, 1.0)) + 20.0 * kDegree, 45.0 * kDegree);
	return {directionOfAngles(azimuth, elevation), {0.0, 0.0, 1.0}};
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

// One axis of the picture. A point at (side, depth) in the camera's axes stays within the slopes [lo, hi] of the
// picture when the eye (e, d) satisfies  side - e >= lo (depth - d)  and  side - e <= hi (depth - d).
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

// The points in the axes of a camera that looks at their middle from afar: right, up, forward.
struct Seen
{
	Vec3 center;
	Vec3 right;
	Vec3 up;
	Vec3 forward;
	double size;
	double nearest = 0.0;
	double farthest = 0.0;
	std::vector<Vec3> points;
};

Seen seenFrom(const Camera& camera, const Box& bounds, std::span<const Vec3> points)
{
	Seen seen{bounds.center(), camera.right(), camera.trueUp(), camera.forward(), bounds.diagonal(), 0.0, 0.0, {}};
	seen.points.reserve(points.size());
	for (const Vec3& p : points)
	{
		const Vec3 at = p - seen.center;
		seen.points.push_back({glm::dot(at, seen.right), glm::dot(at, seen.up), glm::dot(at, seen.forward)});
		seen.nearest = std::min(seen.nearest, seen.points.back().z);
		seen.farthest = std::max(seen.farthest, seen.points.back().z);
	}
	return seen;
}

// Moves the camera until its picture of the points fills the pixels from lo to hi.
Camera fitted(Camera camera, const Seen& seen, const Frame& frame, const glm::dvec2& lo, const glm::dvec2& hi)
{
	const double tangent = std::tan(0.5 * camera.vertical_field * kDegree);
	const double wide = tangent * frame.width / frame.height;
	const auto slope = [](double pixel, double extent) { return 2.0 * pixel / extent - 1.0; };
	AxisFit x{wide * slope(lo.x, frame.width), wide * slope(hi.x, frame.width)};
	AxisFit y{-tangent * slope(hi.y, frame.height), -tangent * slope(lo.y, frame.height)};
	for (const Vec3& p : seen.points)
	{
		x.include(p.x, p.z);
		y.include(p.y, p.z);
	}
	// The eye stays outside the scene even where its picture would leave room to come closer (a flat scene seen edge
	// on).
	const double depth = std::min({x.farthestEye(), y.farthestEye(), seen.nearest - 1e-3 * seen.size});
	const glm::dvec2 least{x.leastEye(depth), y.leastEye(depth)};
	const glm::dvec2 most{x.mostEye(depth), y.mostEye(depth)};
	glm::dvec2 eye = 0.5 * (least + most);
	// Across what the picture does not fill, as much room on either side. Perspective makes this a few steps.
	for (int step = 0; step < 8; ++step)
	{
		glm::dvec2 from(std::numeric_limits<double>::infinity());
		glm::dvec2 to(-std::numeric_limits<double>::infinity());
		for (const Vec3& p : seen.points)
		{
			const glm::dvec2 slopes = (glm::dvec2(p) - eye) / (p.z - depth);
			from = glm::min(from, slopes);
			to = glm::max(to, slopes);
		}
		const glm::dvec2 off = 0.5 * (from + to - glm::dvec2(x.lo + x.hi, y.lo + y.hi));
		eye = glm::clamp(eye + off * (seen.nearest - depth), glm::min(least, most), glm::max(least, most));
	}
	camera.position = seen.center + eye.x * seen.right + eye.y * seen.up + depth * seen.forward;
	camera.focal_point = camera.position + (0.5 * (seen.nearest + seen.farthest) - depth) * seen.forward;
	camera.near = std::max(0.5 * (seen.nearest - depth), 1e-4 * (seen.farthest - depth));
	return camera;
}

// Returns true if a line separates the picture of the points' hull from the frame's corner.
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

Camera makeCamera(const CameraChoice& choice, const probe::Sheet* sheet, std::span<const Vec3> points,
                  const Frame& frame)
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
	const Vec3 center = bounds.empty() ? Vec3(0.0) : bounds.center();
	const double size = bounds.diagonal() > 0.0 ? bounds.diagonal() : 1.0;

	Camera camera;
	camera.vertical_field = choice.camera.vertical_field;
	camera.focal_point = center;
	camera.position = center + size * glm::normalize(view.direction);
	camera.up = view.up;
	camera.up = camera.trueUp();
	if (bounds.diagonal() == 0.0)
		return camera;
	const Seen seen = seenFrom(camera, bounds, points);
	const Camera whole = fitted(camera, seen, frame, frame.free_lo, frame.free_hi);
	if (!frame.corner || staysOffCorner(whole, points, frame))
		return whole;
	const Camera beside = fitted(camera, seen, frame, {frame.corner->x, frame.free_lo.y}, frame.free_hi);
	const Camera above = fitted(camera, seen, frame, frame.free_lo, {frame.free_hi.x, frame.corner->y});
	const auto distance = [&center](const Camera& c) { return glm::dot(center - c.position, c.forward()); };
	return distance(beside) < distance(above) ? beside : above;
}

} // namespace vp::render
