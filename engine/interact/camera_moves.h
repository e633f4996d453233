#pragma once

#include "interact/view.h"
#include "probe/sheet.h"

#include <optional>
#include <span>

namespace vp::interact
{

// How a pointer moves a camera. Drags are computed from the view in which they began, so they do not drift. `scene`
// holds the points to which the near plane is fitted, such as render::extentOf().

struct TurnOptions
{
	std::optional<Vec3> pivot; // a point of the world; by default the focal point
	std::optional<Vec3> pole;  // a direction that stays upright: a turntable, which stops short of either pole
};

// The trackball: the scene follows the pointer as if it were a ball, half a turn over the shorter side of the picture.
// Up is carried along, perpendicular to the line of sight.
render::Camera turned(const View& start, const glm::dvec2& from, const glm::dvec2& to, std::span<const Vec3> scene,
                      const TurnOptions& options = {});

// About the line of sight, the picture counter-clockwise.
render::Camera rolled(const render::Camera& camera, double degrees);

// Moves the camera so that the point under the first pixel comes to lie under the second. The point is as deep as
// `point`, by default the focal point.
render::Camera panned(const View& start, const glm::dvec2& from, const glm::dvec2& to, std::span<const Vec3> scene,
                      const std::optional<Vec3>& point = {});

// `factor` (> 0) times nearer to what lies under the pixel, as deep as `point` (by default the focal point); it stays
// there. The focal point stays between 1e-6 and 100 of the scene's diagonal away, or as far as it was.
render::Camera zoomed(const View& view, const glm::dvec2& pixel, double factor, std::span<const Vec3> scene,
                      const std::optional<Vec3>& point = {});

enum class NamedView
{
	x, // from there
	minus_x,
	y,
	minus_y,
	z,
	minus_z,
	iso
};
constexpr int kNamedViews = 7;

// These fill the free area of the view's frame, and keep its field of view.
render::Camera namedView(const View& view, NamedView name, std::span<const Vec3> scene);
render::Camera fitted(const View& view, std::span<const Vec3> scene); // from where the camera looks now

// Straight onto a sheet, its up upright: its window fills the free area, or else the scene.
render::Camera faceSheet(const View& view, const probe::Sheet& placed, std::span<const Vec3> scene);

} // namespace vp::interact
