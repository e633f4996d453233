#pragma once

#include "base/vec.h"
#include "grid/grid.h"

#include <span>

namespace vp::locate
{

// The plane that fits a face. It passes through the mean of the points. Its normal is the vector area, which is half
// the sum of the cross products about the mean, and is zero for a collapsed face.
struct FacePlane
{
	Vec3 center;
	Vec3 normal; // not of unit length
};

template <grid::Grid G>
FacePlane facePlane(const G& grid, std::span<const PointId> face)
{
	Vec3 center(0.0);
	for (const PointId p : face)
		center += grid.point(p);
	center /= static_cast<double>(face.size());
	Vec3 normal(0.0);
	Vec3 previous = grid.point(face.back()) - center;
	for (const PointId p : face)
	{
		const Vec3 spoke = grid.point(p) - center;
		normal += glm::cross(previous, spoke);
		previous = spoke;
	}
	return {center, 0.5 * normal};
}

} // namespace vp::locate
