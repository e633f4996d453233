#pragma once

#include "base/vec.h"

namespace vp::surface
{

// Where a frame's origin and axes lie in the world; unit vectors at right angles.
struct Axes
{
	Vec3 origin{0.0};
	Vec3 x{1.0, 0.0, 0.0};
	Vec3 y{0.0, 1.0, 0.0};
	Vec3 z{0.0, 0.0, 1.0};

	bool operator==(const Axes&) const = default;
};

} // namespace vp::surface
