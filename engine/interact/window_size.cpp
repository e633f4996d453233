#include "interact/window_size.h"

#include <algorithm>
#include <cassert>

namespace vp::interact
{

namespace
{

double bounded(double size, double now, double scene_size)
{
	return std::clamp(size, std::min(now, kSmallestWindow * scene_size), std::max(now, kLargestWindow * scene_size));
}

} // namespace

probe::Window withSideMoved(const probe::Window& window, int side, double way, bool both_sides, double scene_size)
{
	assert(side >= 0 && side < 4);
	if (way == 0.0)
		return window;
	probe::Window result = window;
	double& lo = side < 2 ? result.x0 : result.y0;
	double& hi = side < 2 ? result.x1 : result.y1;
	const bool moves_hi = side % 2 == 1;
	const double now = hi - lo;
	const double grown = (moves_hi ? way : -way) * (both_sides ? 2.0 : 1.0);
	const double size = bounded(now + grown, now, scene_size);
	if (both_sides)
	{
		const double middle = 0.5 * (lo + hi);
		lo = middle - 0.5 * size;
		hi = middle + 0.5 * size;
	}
	else if (moves_hi)
		hi = lo + size;
	else
		lo = hi - size;
	return result;
}

probe::Window scaled(const probe::Window& window, double factor, const glm::dvec2& about, double scene_size)
{
	assert(factor > 0.0);
	const double shorter = std::min(window.width(), window.height());
	const double longer = std::max(window.width(), window.height());
	const double f = factor < 1.0 ? bounded(factor * shorter, shorter, scene_size) / shorter
	                              : bounded(factor * longer, longer, scene_size) / longer;
	const auto side = [f](double at, double from) { return from + f * (at - from); };
	return {side(window.x0, about.x), side(window.x1, about.x), side(window.y0, about.y), side(window.y1, about.y)};
}

probe::Probe withWindow(const probe::Probe& probe, std::size_t sheet, const probe::Window& window, bool own)
{
	assert(sheet < probe.sheets.size() && probe.sheets[sheet].window);
	const probe::Window first = *probe.sheets[sheet].window;
	probe::Probe result = probe;
	if (own)
		result.sheets[sheet].window = window;
	else
		for (probe::Sheet& other : result.sheets)
			if (other.window == first)
				other.window = window;
	return result;
}

} // namespace vp::interact
