#include "seed/sheet_window.h"

#include <cassert>

namespace vp::seed
{

SheetWindow::SheetWindow(const probe::Sheet& content)
    : origin_(content.origin), x_axis_(content.xAxis()), y_axis_(content.up), hot_spot_(content.origin)
{
	assert(content.window);
	const probe::Window& window = *content.window;
	const Uv center = 0.5 * Uv(window.x0 + window.x1, window.y0 + window.y1);
	if (window.x0 > 0.0 || window.x1 < 0.0 || window.y0 > 0.0 || window.y1 < 0.0)
		hot_spot_ = origin_ + center.x * x_axis_ + center.y * y_axis_;
	// The rounding of a point far from the origin.
	const double reach = glm::length(origin_) + glm::length(center) + window.width() + window.height();
	slack_ = 1e-14 * reach;
	reach_squared_ = reach * reach;
	lo_ = Uv(window.x0, window.y0) - slack_;
	hi_ = Uv(window.x1, window.y1) + slack_;
}

bool SheetWindow::meets(const Box& box) const
{
	const Uv center = uvOf(box.center());
	const Vec3 half = 0.5 * box.size();
	const Uv reach(glm::dot(glm::abs(x_axis_), half), glm::dot(glm::abs(y_axis_), half));
	return center.x + reach.x >= lo_.x && center.x - reach.x <= hi_.x && center.y + reach.y >= lo_.y &&
	       center.y - reach.y <= hi_.y;
}

bool SheetWindow::meets(const Vec3& from, const Vec3& to) const
{
	return reachesInto(uvOf(from), uvOf(to), lo_, hi_);
}

bool SheetWindow::passesRightOfCenter(const Uv& from, const Uv& to) const
{
	const Uv center = 0.5 * (lo_ + hi_);
	if ((from.y > center.y) == (to.y > center.y))
		return false;
	const double t = (center.y - from.y) / (to.y - from.y);
	return from.x + t * (to.x - from.x) > center.x;
}

bool SheetWindow::isAboutCenter(const Cuts& cuts) const
{
	bool inside = false;
	for (int cut = 0; cut < cuts.count; ++cut)
		inside ^= passesRightOfCenter(cuts.at[cut], cuts.at[(cut + 1) % cuts.count]);
	return inside;
}

} // namespace vp::seed
