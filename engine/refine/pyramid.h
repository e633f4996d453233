#pragma once

#include "grid/curved/pyramid_weights.h"

#include <span>

namespace vp::refine
{

/// How far from linear a pyramid (grid/pyramid_weights.h) is within a part: a bound by the largest second derivatives.
class PyramidBend
{
public:
	/// nodes: 5 or 13.
	explicit PyramidBend(std::span<const Vec3> nodes);

	/// Returns a bound on how far the cell is from the linear cell between the corners of a tetrahedron that lies in
	/// this box of the cell's coordinates.
	double within(const Vec3& lo, const Vec3& hi) const;

private:
	double second_[6]; // bounds for the polynomial part: xx, yy, zz, xy, xz, yz
	double rational_[3];
};

} // namespace vp::refine
