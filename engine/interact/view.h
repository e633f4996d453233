#pragma once

#include "base/vec.h"
#include "render/scene/camera.h"

#include <array>
#include <optional>

namespace vp::interact
{

// The picture that a user sees. Pixels are counted from the frame's top left, y down, with pixel centers at halves. If
// the frame is only a part of a window, the caller subtracts the frame's place in the window.
struct View
{
	render::Camera camera;
	render::Frame frame;
};

// The line of points under a pixel. It starts at the eye. `along` has length 1 along the camera's forward().
struct Ray
{
	Vec3 from;
	Vec3 along;

	Vec3 at(double depth) const { return from + depth * along; }
};

Ray rayOf(const View& view, const glm::dvec2& pixel);

// Along the camera's forward(); negative behind the eye.
double depthOf(const View& view, const Vec3& point);

// Returns where a point is seen, or nothing if it is nearer than the near plane.
std::optional<glm::dvec2> pixelOf(const View& view, const Vec3& point);

// Returns how long a length of 1 across the line of sight is seen at a depth > 0.
double pixelsPerLength(const View& view, double depth);

// The part of a segment beyond the near plane, in pixels.
std::optional<std::array<glm::dvec2, 2>> seenSegment(const View& view, const Vec3& a, const Vec3& b);

// The depth at which a ray meets the plane through a point; none where it does not in front of the eye.
std::optional<double> depthOnPlane(const Ray& ray, const Vec3& through, const Vec3& normal);

} // namespace vp::interact
