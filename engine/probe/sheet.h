#pragma once

#include "base/vec.h"
#include "surface/plane.h"

#include <vector>

namespace vp::probe
{

// A cutting plane with a frame of its own: its x axis is up x normal, its y axis up, its z axis the normal; the origin
// is the hot spot.
struct Sheet
{
	Vec3 origin{0.0};
	Vec3 normal{0.0, 0.0, 1.0}; // unit
	Vec3 up{0.0, 1.0, 0.0};     // unit, perpendicular to the normal

	Vec3 xAxis() const { return glm::cross(up, normal); }
	surface::Plane plane() const { return {origin, normal}; }
};

// normal of any length but zero; up is made perpendicular to it, and x (or y) stands in where the two are parallel.
Sheet makeSheet(const Vec3& origin, const Vec3& normal, const Vec3& up = {0.0, 1.0, 0.0});

// Sheets moved as one.
struct Probe
{
	std::vector<Sheet> sheets;
};

} // namespace vp::probe
