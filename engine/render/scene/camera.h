#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "probe/sheet.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vp::render
{

// The picture in pixels, and the part of it that legend, title and caption leave to the scene: from free_lo (top left)
// to free_hi, without the lower left corner, left of and below `corner`, where the axes are.
struct Frame
{
	double width = 1.0;
	double height = 1.0;
	glm::dvec2 free_lo{0.0};
	glm::dvec2 free_hi{1.0};
	std::optional<glm::dvec2> corner;
};

// The field of view of a perspective camera, degrees.
constexpr double kUsualField = 25.0;

enum class Projection : std::uint8_t
{
	perspective,
	parallel // from so far away that lines which are parallel in space are so in the picture, to a part of a pixel
};

// A perspective view. Clip space is Vulkan's (y down), depth reversed without a far end: near / w, so that depth is
// linear in the picture plane and loses nothing far away.
struct Camera
{
	Vec3 position{0.0, 0.0, 1.0};
	Vec3 focal_point{0.0};
	Vec3 up{0.0, 1.0, 0.0};
	double vertical_field = kUsualField; // field of view, degrees
	double near = 1e-3;

	Vec3 forward() const;
	Vec3 right() const;
	Vec3 trueUp() const; // perpendicular to forward()
	glm::dmat4 view() const;
	glm::dmat4 projection(double aspect) const;

	// The pixel of a point in front of the camera; x to the right, y down, pixel centers at halves.
	glm::dvec2 project(const Vec3& point, const Frame& frame) const;

	// Returns the direction in which the eye looks through a pixel. Its length along forward() is 1.
	Vec3 ray(const glm::dvec2& pixel, const Frame& frame) const;

	// Puts the near plane before the points, as far from the eye as they allow.
	void fitNear(std::span<const Vec3> points);
};

/// How the picture is looked at. Made by parseCamera() or fixedCamera(); a default one is automatic.
struct CameraChoice
{
	enum class Kind
	{
		automatic, // obliquely onto the first sheet
		sheet,     // straight onto the first sheet, its up axis upright
		direction, // from `direction` (from the scene to the eye), `up` upright
		fixed      // `camera` as it is; nothing is fitted
	};
	Kind kind = Kind::automatic;
	Vec3 direction{0.0};
	Vec3 up{0.0};
	Camera camera;             // a fitted camera uses only its field of view
	std::string text = "auto"; // as parseCamera() takes it

	bool followsSheet() const { return kind == Kind::sheet; }
	bool operator==(const CameraChoice& other) const { return text == other.text; }
};

// `auto`, `x|-x|y|-y|z|-z` (seen from there), `iso`, `sheet`, `AZ,EL` in degrees (azimuth from x towards y, elevation
// from the xy plane towards z), or nine numbers: position, focal point, up. Anything else is a usage error, which does
// not name the setting.
Result<CameraChoice> parseCamera(std::string_view text);

/// A camera that is not fitted to anything. Its text is read as the same camera again, to the last bit. One of a
/// parallel projection becomes the perspective camera that shows its focal point as large.
CameraChoice fixedCamera(const Camera& camera);

/// Returns the same choice in a projection. A fixed camera shows its focal point as large as in perspective.
CameraChoice projected(CameraChoice choice, Projection projection);

/// Returns how many times farther away a camera is than a perspective one that shows its focal point as large.
double farther(const Camera& camera);

// A camera whose picture of the points just fills the frame's free area. `sheet` may be null where there is none.
Camera makeCamera(const CameraChoice& choice, const probe::Sheet* sheet, std::span<const Vec3> points,
                  const Frame& frame);

} // namespace vp::render
