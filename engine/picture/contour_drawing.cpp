#include "picture/contour_drawing.h"

#include "ranks/picture/joined_surfaces.h"

#include <utility>

namespace vp::picture
{

Status addContours(const session::Session& session, const cut::SheetCut& sheet,
                   std::span<const ranks::GrownContour> contours, const render::SheetDrawing& drawing,
                   const view::ResolvedLook& choice, render::Scene& scene)
{
	if (contours.empty())
		return Nothing{};
	const bool colored = !choice.byGeneration(); // whose scale is none of the values'
	auto polygons = ranks::contourPolygons(session.ranks(), *session.device(), sheet, contours, colored);
	if (!polygons)
		return polygons.error();
	if (!*polygons)
		return Nothing{};
	render::Surface& surface = scene.surfaces.emplace_back();
	surface.polygons = std::move(*polygons);
	surface.opacity = choice.spec.contour.opacity;
	surface.mesh = choice.look.mesh;
	surface.lines = 0; // one value has no lines
	if (!colored)
		return Nothing{};
	surface.values = drawing.values ? drawing.values : scene.values;
	surface.colors = drawing.colors;
	surface.range = drawing.range || drawing.values ? drawing.range : choice.look.range;
	return Nothing{};
}

} // namespace vp::picture
