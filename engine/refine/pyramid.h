#pragma once

#include "base/vec.h"

#include <span>

namespace vp::refine
{

// Pyramids over the unit square with their top at (1/2, 1/2, 1). Their shape functions are rational: Bedrosian's
// ("Shape functions and integration formulas for three-dimensional finite element analysis", 1992), which hold all
// quadratic polynomials. Corners are in VTK's order, then the middles of the edges of the base, then of those to the
// top.

/// Writes the shape functions of 5 or of 13 nodes.
void weighPyramid(const Vec3& at, std::span<double> weights);

/// How far from linear the cell is within a part: a bound by the largest second derivatives.
class PyramidBend
{
public:
	/// nodes: 5 or 13.
	explicit PyramidBend(std::span<const Vec3> nodes);

	/// Returns a bound on how far the cell is from the linear cell between the corners of a tetrahedron that lies in
	/// this box of the cell's coordinates.
	double within(const Vec3& lo, const Vec3& hi) const;

private:
	double second_[6]; // of the polynomial part: xx, yy, zz, xy, xz, yz
	double rational_[3];
};

} // namespace vp::refine
