#include "contour/clip_box.h"

namespace vp::contour
{

ClipBox::ClipBox(const probe::Frame& frame, const Vec3& lo, const Vec3& hi)
    : frame_(frame), x_axis_(frame.xAxis()), box_{lo, hi}
{
	// The rounding of a point far from the origin.
	const double reach = glm::length(frame.origin) + glm::length(lo) + glm::length(hi);
	lo_ = lo - Vec3(1e-14 * reach);
	hi_ = hi + Vec3(1e-14 * reach);
}

bool ClipBox::holdsPartOf(const Box& section) const
{
	for (int axis = 0; axis < 3; ++axis)
		if (!(section.hi[axis] >= lo_[axis] && section.lo[axis] <= hi_[axis]))
			return false;
	return true;
}

bool ClipBox::meets(const Box& box) const
{
	const Vec3 middle = inBox(box.center());
	const Vec3 half = 0.5 * box.size();
	const Vec3 reach(glm::dot(glm::abs(x_axis_), half), glm::dot(glm::abs(frame_.up), half),
	                 glm::dot(glm::abs(frame_.normal), half));
	const Vec3 slack = 1e-12 * (glm::abs(middle) + reach);
	return holdsPartOf({middle - reach - slack, middle + reach + slack});
}

std::array<mesh::ClipSide, 6> ClipBox::sides() const
{
	return {mesh::ClipSide{x_axis_, box_.lo.x},       mesh::ClipSide{-x_axis_, -box_.hi.x},
	        mesh::ClipSide{frame_.up, box_.lo.y},     mesh::ClipSide{-frame_.up, -box_.hi.y},
	        mesh::ClipSide{frame_.normal, box_.lo.z}, mesh::ClipSide{-frame_.normal, -box_.hi.z}};
}

} // namespace vp::contour
