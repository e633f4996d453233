#pragma once

#include "base/vec.h"
#include "grid/grid.h"

#include <span>

namespace vp::locate
{

// The plane that fits a face: through the mean of its points, its normal the vector area (half the sum of the cross
// products about the mean), zero for a collapsed face.
struct FacePlane
{
	Vec3 centre;
	Vec3 normal; // not of unit length
};

template <grid::Grid G>
FacePlane facePlane(const G& grid, std::span<const PointId> face)
{
	Vec3 centre(0.0);
	for (const PointId p : face)
		centre += grid.point(p);
	centre /= static_cast<double>(face.size());
	Vec3 normal(0.0);
	Vec3 previous = grid.point(face.back()) - centre;
	for (const PointId p : face)
	{
		const Vec3 spoke = grid.point(p) - centre;
		normal += glm::cross(previous, spoke);
		previous = spoke;
	}
	return {centre, 0.5 * normal};
}

} // namespace vp::locate
