#pragma once

#include "base/vec.h"

#include <array>

namespace vp::probe
{

// An affine map of points, in double.
//
// Written as in the paper (Speray and Kennon 1990, "Probes"): points are rows and transforms post-multiply them,
// x' = x M, so a product a * b applies a first, and the bottom row of M is where the origin goes. GLM's points are
// columns, x' = M^T x: its matrix of the same map is the transpose, its product runs the other way round, and what the
// paper calls row i is GLM's column i. Both keep the same 16 numbers in the same order in memory.
struct Transform
{
	// Rows 0 to 2: where the unit vectors along x, y and z go. Row 3, the bottom row: where the origin goes.
	std::array<Vec3, 4> row{Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0), Vec3(0.0)};

	Vec3 vector(const Vec3& v) const { return v.x * row[0] + v.y * row[1] + v.z * row[2]; }
	Vec3 point(const Vec3& p) const { return vector(p) + row[3]; }
	glm::dmat4 glmMatrix() const; // glmMatrix() * dvec4(p, 1) is point(p)

	bool operator==(const Transform&) const = default;
};

// Applies a first, then b.
Transform operator*(const Transform& a, const Transform& b);

// Returns the inverse. The map must be invertible.
Transform inverse(const Transform& transform);

// The place of a rigid object in the coordinates of its holder: its origin, its z axis (normal) and its y axis (up).
// Its x axis is up x normal. The holder of a probe is the world, the holder of a sheet is its probe.
struct Frame
{
	Vec3 origin{0.0};
	Vec3 normal{0.0, 0.0, 1.0}; // unit
	Vec3 up{0.0, 1.0, 0.0};     // unit, perpendicular to the normal

	Vec3 xAxis() const { return glm::cross(up, normal); }

	bool operator==(const Frame&) const = default;
};

// Makes a frame. normal may have any length but zero. up is made perpendicular to it; if the two are parallel, x (or y)
// replaces up. Unit vectors at right angles are kept to the last bit.
Frame makeFrame(const Vec3& origin, const Vec3& normal, const Vec3& up = {0.0, 1.0, 0.0});

// Returns the map from the holder's coordinates to those of the frame: to_probe for a probe, to_sheet for a sheet.
Transform toFrame(const Frame& frame);
Transform fromFrame(const Frame& frame); // the inverse; its bottom row is the frame's origin, to the last bit

// Returns a frame that is given in `holder`'s coordinates in the coordinates of the holder of `holder`.
Frame placed(const Frame& frame, const Frame& holder);

// Returns a frame turned by an angle about the axis through a point, counter-clockwise seen against the axis. axis may
// have any length but zero. Quarter turns about x, y and z are exact, so that vanes lie exactly in planes of the grid.
Frame turned(const Frame& frame, const Vec3& through, const Vec3& axis, double degrees);

// Returns the unit vector. The length may be anything but zero, even if its square is beyond the range of double.
Vec3 unitVector(const Vec3& v);

} // namespace vp::probe
