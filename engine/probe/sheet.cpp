#include "probe/sheet.h"

#include <cassert>

namespace vp::probe
{

Sheet makeSheet(const Vec3& origin, const Vec3& normal, const Vec3& up)
{
	return {makeFrame(origin, normal, up), {}, {}, {}};
}

Transform fxTransform(const Fx& fx)
{
	assert(fx.magnification > 0.0);
	const double m = fx.magnification;
	return {{Vec3(m, 0.0, 0.0), Vec3(0.0, m, 0.0), Vec3(0.0, 0.0, m), -m * fx.pan}};
}

Transform toCube(const Window& window)
{
	assert(window.width() > 0.0 && window.height() > 0.0);
	const double x = 1.0 / window.width();
	const double y = 1.0 / window.height();
	return {{Vec3(x, 0.0, 0.0), Vec3(0.0, y, 0.0), Vec3(0.0, 0.0, 1.0), Vec3(-window.x0 * x, -window.y0 * y, 0.0)}};
}

Transform worldToSheet(const Sheet& sheet)
{
	const Transform shown = toFrame(sheet) * fxTransform(sheet.fx);
	return sheet.window ? shown * toCube(*sheet.window) : shown;
}

Transform sheetToWorld(const Sheet& sheet)
{
	return sheet.window ? inverse(toCube(*sheet.window)) * fromFrame(sheet) : fromFrame(sheet);
}

Vec3 contentHotSpot(const Sheet& sheet)
{
	return fromFrame(sheet).point(sheet.fx.pan);
}

Sheet content(const Sheet& sheet)
{
	Sheet cut = sheet;
	cut.fx = {};
	cut.origin = contentHotSpot(sheet);
	if (sheet.window)
	{
		const Window& w = *sheet.window;
		const double m = sheet.fx.magnification;
		cut.window = Window{w.x0 / m, w.x1 / m, w.y0 / m, w.y1 / m};
	}
	return cut;
}

Transform displayTransform(const Sheet& sheet)
{
	const double m = sheet.fx.magnification;
	return {{Vec3(m, 0.0, 0.0), Vec3(0.0, m, 0.0), Vec3(0.0, 0.0, m), sheet.origin - m * contentHotSpot(sheet)}};
}

glm::dvec2 worldToWindow(const Sheet& sheet, const Vec3& point)
{
	assert(sheet.window);
	// From the hot spot before anything else: far from zero the product's bottom row would cost digits.
	const Vec3 arm = sheet.fx.magnification * (point - contentHotSpot(sheet));
	const Window& window = *sheet.window;
	return {(glm::dot(arm, sheet.xAxis()) - window.x0) / window.width(),
	        (glm::dot(arm, sheet.up) - window.y0) / window.height()};
}

} // namespace vp::probe
