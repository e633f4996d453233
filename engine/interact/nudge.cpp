#include "interact/nudge.h"

#include "interact/handles.h"
#include "interact/steps.h"

#include <algorithm>
#include <cassert>

namespace vp::interact
{

probe::Probe pushed(const probe::Probe& probe, std::size_t sheet, double steps, const Box& bounds, bool fine, bool own)
{
	const double way = steps * roundStep(bounds) * (fine ? 0.1 : 1.0);
	return moved(probe, own ? Part(sheet) : Part(), way * frameOf(probe, sheet).normal);
}

probe::Probe turnedAbout(const probe::Probe& probe, const Part& part, int axis, double degrees)
{
	return turned(probe, part, axisOf(frameOf(probe, part), axis), degrees);
}

probe::Probe withWindowScaled(const probe::Probe& probe, std::size_t sheet, double factor, const Box& bounds, bool own)
{
	assert(sheet < probe.sheets.size());
	const std::optional<probe::Window>& w = probe.sheets[sheet].window;
	const glm::dvec2 center = w ? 0.5 * glm::dvec2(w->x0 + w->x1, w->y0 + w->y1) : glm::dvec2(0.0);
	return withWindowScaled(probe, sheet, factor, center, bounds, own);
}

probe::Probe withWindowScaled(const probe::Probe& probe, std::size_t sheet, double factor, const glm::dvec2& about,
                              const Box& bounds, bool own)
{
	assert(sheet < probe.sheets.size());
	const std::optional<probe::Window>& window = probe.sheets[sheet].window;
	if (!window)
		return probe;
	return withWindow(probe, sheet, scaled(*window, factor, about, sizeOf(bounds)), own);
}

probe::Probe magnified(const probe::Probe& probe, std::size_t sheet, double factor, const glm::dvec2& uv)
{
	assert(sheet < probe.sheets.size() && factor > 0.0);
	probe::Probe result = probe;
	probe::Fx& fx = result.sheets[sheet].fx;
	const double now = fx.magnification;
	fx.magnification = std::clamp(now * factor, std::min(now, kMinMagnification), std::max(now, kMaxMagnification));
	fx.pan += Vec3(uv / now - uv / fx.magnification, 0.0);
	return result;
}

probe::Probe magnifierPanned(const probe::Probe& probe, std::size_t sheet, const glm::dvec2& from, const glm::dvec2& to)
{
	assert(sheet < probe.sheets.size());
	probe::Probe result = probe;
	probe::Fx& fx = result.sheets[sheet].fx;
	fx.pan -= Vec3((to - from) / fx.magnification, 0.0);
	return result;
}

probe::Probe withoutMagnifier(const probe::Probe& probe, std::size_t sheet)
{
	assert(sheet < probe.sheets.size());
	probe::Probe result = probe;
	result.sheets[sheet].fx = {};
	return result;
}

probe::Probe withNormalToCamera(const probe::Probe& probe, const Part& part, const render::Camera& camera)
{
	return withNormal(probe, part, -camera.forward());
}

} // namespace vp::interact
