#include "interact/camera_moves.h"

#include "base/angle.h"
#include "interact/handles.h"
#include "interact/steps.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vp::interact
{

namespace
{

constexpr double kNearestToPole = 0.5; // degrees; at the pole itself nothing is upright

// About axes through the pivot, one turn after the other.
struct Turning
{
	render::Camera camera;
	Vec3 pivot;

	void turn(const Vec3& axis, double degrees)
	{
		if (degrees == 0.0)
			return;
		const probe::Frame first = probe::makeFrame(camera.position, -camera.forward(), camera.trueUp());
		const double distance = glm::length(camera.focal_point - camera.position);
		const probe::Frame frame = probe::turned(first, pivot, axis, degrees);
		camera.position = frame.origin;
		camera.focal_point = frame.origin - distance * frame.normal;
		camera.up = frame.up;
	}
};

Box boxOf(std::span<const Vec3> points)
{
	Box box;
	for (const Vec3& p : points)
		box.include(p);
	return box;
}

void turnBall(Turning& turning, const glm::dvec2& degrees)
{
	const Vec3 axis = degrees.x * turning.camera.trueUp() + degrees.y * turning.camera.right();
	if (const double length = glm::length(degrees); length > 0.0)
		turning.turn(axis, -length);
}

void turnTable(Turning& turning, const glm::dvec2& degrees, const Vec3& pole)
{
	const Vec3 up = probe::unitVector(pole);
	const Vec3 back = -turning.camera.forward();
	const double from_pole = std::acos(std::clamp(glm::dot(back, up), -1.0, 1.0)) / kDegree;
	// A camera that stands at the pole already stays free to leave it.
	const double least = std::min(from_pole, kNearestToPole);
	const double most = std::max(from_pole, 180.0 - kNearestToPole);
	const double tilt = std::clamp(from_pole - degrees.y, least, most) - from_pole;
	turning.turn(turning.camera.right(), tilt);
	turning.turn(up, -degrees.x);
}

double depthFor(const View& view, const std::optional<Vec3>& point)
{
	const double depth = depthOf(view, point.value_or(view.camera.focal_point));
	return depth > view.camera.near ? depth : depthOf(view, view.camera.focal_point);
}

render::Camera filling(const View& view, render::CameraChoice choice, const probe::Sheet* sheet,
                       std::span<const Vec3> scene)
{
	choice.camera.vertical_field = view.camera.vertical_field;
	return render::makeCamera(choice, sheet, scene, view.frame);
}

} // namespace

render::Camera turned(const View& start, const glm::dvec2& from, const glm::dvec2& to, std::span<const Vec3> scene,
                      const TurnOptions& options)
{
	if (from == to)
		return start.camera;
	Turning turning{start.camera, options.pivot.value_or(start.camera.focal_point)};
	const glm::dvec2 degrees = (to - from) * 180.0 / std::min(start.frame.width, start.frame.height);
	if (options.pole)
		turnTable(turning, degrees, *options.pole);
	else
		turnBall(turning, degrees);
	turning.camera.fitNear(scene);
	return turning.camera;
}

render::Camera rolled(const render::Camera& camera, double degrees)
{
	Turning turning{camera, camera.focal_point};
	// The camera goes the other way.
	turning.turn(-camera.forward(), -degrees);
	turning.camera.position = camera.position;
	turning.camera.focal_point = camera.focal_point;
	return turning.camera;
}

render::Camera panned(const View& start, const glm::dvec2& from, const glm::dvec2& to, std::span<const Vec3> scene,
                      const std::optional<Vec3>& point)
{
	if (from == to)
		return start.camera;
	const double depth = depthFor(start, point);
	const Vec3 way = depth * (rayOf(start, from).along - rayOf(start, to).along);
	render::Camera camera = start.camera;
	camera.position += way;
	camera.focal_point += way;
	camera.fitNear(scene);
	return camera;
}

render::Camera zoomed(const View& view, const glm::dvec2& pixel, double factor, std::span<const Vec3> scene,
                      const std::optional<Vec3>& point)
{
	assert(factor > 0.0);
	const double size = render::farther(view.camera) * sizeOf(boxOf(scene));
	const double now = depthOf(view, view.camera.focal_point);
	const double wanted = std::clamp(now / factor, std::min(now, 1e-6 * size), std::max(now, 100.0 * size));
	const Vec3 under = rayOf(view, pixel).at(depthFor(view, point));
	const Vec3 way = (1.0 - wanted / now) * (under - view.camera.position);
	render::Camera camera = view.camera;
	camera.position += way;
	camera.focal_point = camera.position + wanted * view.camera.forward();
	camera.fitNear(scene);
	return camera;
}

render::Camera namedView(const View& view, NamedView name, std::span<const Vec3> scene)
{
	constexpr std::array<std::string_view, kNamedViews> kNames{"x", "-x", "y", "-y", "z", "-z", "iso"};
	return filling(view, render::parseCamera(kNames[static_cast<std::size_t>(name)]).value(), nullptr, scene);
}

render::Camera fitted(const View& view, std::span<const Vec3> scene)
{
	render::CameraChoice choice;
	choice.kind = render::CameraChoice::Kind::direction;
	choice.direction = -view.camera.forward();
	choice.up = view.camera.trueUp();
	return filling(view, choice, nullptr, scene);
}

render::Camera faceSheet(const View& view, const probe::Sheet& placed, std::span<const Vec3> scene)
{
	render::CameraChoice choice;
	choice.kind = render::CameraChoice::Kind::sheet;
	if (!placed.window)
		return filling(view, choice, &placed, scene);
	render::Camera camera = filling(view, choice, &placed, windowCorners(placed));
	camera.fitNear(scene);
	return camera;
}

} // namespace vp::interact
