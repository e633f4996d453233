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

// First a, then b.
Transform operator*(const Transform& a, const Transform& b);

// Of a map that flattens nothing.
Transform inverse(const Transform& transform);

// Where a rigid thing stands in the coordinates of what holds it: its origin, its z axis (normal) and y axis (up). Its
// x axis is up x normal. A probe's frame is given in the world, a sheet's in its probe.
struct Frame
{
	Vec3 origin{0.0};
	Vec3 normal{0.0, 0.0, 1.0}; // unit
	Vec3 up{0.0, 1.0, 0.0};     // unit, perpendicular to the normal

	Vec3 xAxis() const { return glm::cross(up, normal); }

	bool operator==(const Frame&) const = default;
};

// normal of any length but zero; up is made perpendicular to it, and x (or y) stands in where the two are parallel. A
// normal and an up that already are unit vectors at right angles are kept to the last bit.
Frame makeFrame(const Vec3& origin, const Vec3& normal, const Vec3& up = {0.0, 1.0, 0.0});

// From the holder's coordinates to the frame's: to_probe of a probe's frame, to_sheet of a sheet's.
Transform toFrame(const Frame& frame);
Transform fromFrame(const Frame& frame); // the inverse; its bottom row is the frame's origin, to the last bit

// A frame given in `holder`'s coordinates, in those of what holds `holder`.
Frame placed(const Frame& frame, const Frame& holder);

// Turned by an angle about the axis through a point, counter-clockwise seen against the axis. axis of any length but
// zero. Quarter turns about x, y and z are exact, so that a vane that should lie in the grid's planes does.
Frame turned(const Frame& frame, const Vec3& through, const Vec3& axis, double degrees);

// Of any length but zero, squares beyond the range of double included.
Vec3 unitVector(const Vec3& v);

} // namespace vp::probe
