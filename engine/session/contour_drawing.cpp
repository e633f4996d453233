#include "session/contour_drawing.h"

#include "render/passes/surface_polygons.h"

namespace vp::session
{

namespace
{

// All in one mesh, where the sheet shows them: places and polygons are all that is drawn.
mesh::SheetMesh joined(const cut::SheetCut& sheet, std::span<const contour::Contour> contours,
                       std::vector<double>& values)
{
	const probe::Transform shown = probe::displayTransform(sheet.shown);
	mesh::SheetMesh all;
	all.flat = false;
	all.polygon_starts.push_back(0);
	for (const contour::Contour& contour : contours)
	{
		const auto first = static_cast<std::uint32_t>(all.positions.size());
		for (const Vec3& p : contour.mesh.positions)
			all.positions.push_back(shown.point(p));
		for (std::size_t p = 0; p < contour.mesh.polygons(); ++p)
		{
			for (const std::uint32_t v : contour.mesh.polygon(p))
				all.polygon_vertices.push_back(first + v);
			all.polygon_starts.push_back(static_cast<std::uint32_t>(all.polygon_vertices.size()));
			all.polygon_cells.push_back(contour.mesh.polygon_cells[p]);
		}
		values.resize(all.positions.size(), contour.value);
	}
	return all;
}

} // namespace

Status addContours(const Session& session, const cut::SheetCut& sheet, std::span<const contour::Contour> contours,
                   const render::SheetDrawing& drawing, const view::ResolvedLook& choice, render::Scene& scene)
{
	std::vector<double> values;
	const mesh::SheetMesh mesh = joined(sheet, contours, values);
	if (mesh.polygons() == 0)
		return Nothing{};
	const bool colored = !choice.by_generation; // whose scale is none of the values'
	auto polygons = render::surfacePolygons(*session.device, mesh,
	                                        colored ? render::SurfaceValues{values, {}} : render::SurfaceValues{});
	if (!polygons)
		return polygons.error();
	render::Surface& surface = scene.surfaces.emplace_back();
	surface.polygons = std::move(*polygons);
	surface.opacity = choice.contour.opacity;
	surface.mesh = choice.look.mesh;
	surface.lines = 0; // one value has no lines
	if (!colored)
		return Nothing{};
	surface.values = drawing.values ? drawing.values : scene.values;
	surface.colors = drawing.colors;
	surface.range = drawing.range || drawing.values ? drawing.range : choice.look.range;
	return Nothing{};
}

} // namespace vp::session
