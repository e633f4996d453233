#include "picture/contour_drawing.h"

#include "ranks/join/polygons_around.h"
#include "ranks/team.h"
#include "render/passes/surface_polygons.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vp::picture
{

namespace
{

// Places of some contours, in one mesh, where the sheet shows them.
class JoinedContours
{
public:
	explicit JoinedContours(const cut::SheetCut& sheet) : shown_(probe::displayTransform(sheet.shown))
	{
		mesh.flat = false;
		mesh.polygon_starts.push_back(0);
	}

	// Returns the number of the first vertex.
	std::uint32_t addVertices(const mesh::SheetMesh& contour, double value)
	{
		const auto first = static_cast<std::uint32_t>(mesh.positions.size());
		for (const Vec3& p : contour.positions)
			mesh.positions.push_back(shown_.point(p));
		values.resize(mesh.positions.size(), value);
		return first;
	}
	// Polygons [begin, end) of a contour.
	void addPolygons(const mesh::SheetMesh& contour, std::uint32_t first_vertex, std::size_t begin, std::size_t end)
	{
		for (std::size_t p = begin; p < end; ++p)
		{
			for (const std::uint32_t v : contour.polygon(p))
				mesh.polygon_vertices.push_back(first_vertex + v);
			mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
			mesh.polygon_cells.push_back(contour.polygon_cells[p]);
		}
	}

	mesh::SheetMesh mesh;
	std::vector<double> values; // per vertex

private:
	probe::Transform shown_;
};

Result<std::shared_ptr<const render::SurfacePolygons>>
polygonsOf(gpu::Device& device, const JoinedContours& joined, bool colored, const render::SurfaceElsewhere* elsewhere)
{
	return render::surfacePolygons(
	    device, joined.mesh, colored ? render::SurfaceValues{joined.values, {}} : render::SurfaceValues{}, elsewhere);
}

// Null if there is nothing to draw.
Result<std::shared_ptr<const render::SurfacePolygons>> polygonsOf(const session::Session& session,
                                                                  const cut::SheetCut& sheet,
                                                                  std::span<const ranks::GrownContour> contours,
                                                                  bool colored)
{
	JoinedContours joined(sheet);
	for (const ranks::GrownContour& contour : contours)
		joined.addPolygons(contour.mesh, joined.addVertices(contour.mesh, contour.value), 0, contour.mesh.polygons());
	if (joined.mesh.polygons() == 0)
		return std::shared_ptr<const render::SurfacePolygons>();
	return polygonsOf(*session.device, joined, colored, nullptr);
}

// The same with a team: polygons of other ranks have a part in how those beside them look, and stand last.
Result<std::shared_ptr<const render::SurfacePolygons>> polygonsOfRank(const session::Session& session,
                                                                      const cut::SheetCut& sheet,
                                                                      std::span<const ranks::GrownContour> contours,
                                                                      bool colored)
{
	JoinedContours joined(sheet);
	Box box;
	std::vector<std::pair<mesh::SheetMesh, std::uint32_t>> around; // and the first vertex
	for (const ranks::GrownContour& contour : contours)
	{
		mesh::SheetMesh mesh = contour.mesh;
		std::vector<double> none;
		ranks::addPolygonsAround(*session.team, contour.borders, mesh, none);
		const std::uint32_t first = joined.addVertices(mesh, contour.value);
		for (std::size_t v = 0; v < contour.mesh.positions.size(); ++v)
			box.include(joined.mesh.positions[first + v]);
		joined.addPolygons(mesh, first, 0, contour.mesh.polygons());
		around.emplace_back(std::move(mesh), first);
	}
	ranks::sumOverAll(*session.team, box, [](Box& all, const Box& other) { all.include(other); });
	if (box.empty())
		return std::shared_ptr<const render::SurfacePolygons>();
	const std::size_t own = joined.mesh.polygons();
	for (std::size_t c = 0; c < contours.size(); ++c)
		joined.addPolygons(around[c].first, around[c].second, contours[c].mesh.polygons(), around[c].first.polygons());
	const render::SurfaceElsewhere elsewhere{.origin = box.center(), .polygons = joined.mesh.polygons() - own};
	return polygonsOf(*session.device, joined, colored, &elsewhere);
}

} // namespace

Status addContours(const session::Session& session, const cut::SheetCut& sheet,
                   std::span<const ranks::GrownContour> contours, const render::SheetDrawing& drawing,
                   const view::ResolvedLook& choice, render::Scene& scene)
{
	if (contours.empty())
		return Nothing{};
	const bool colored = !choice.by_generation; // whose scale is none of the values'
	auto polygons = session.team ? polygonsOfRank(session, sheet, contours, colored)
	                             : polygonsOf(session, sheet, contours, colored);
	if (!polygons)
		return polygons.error();
	if (!*polygons)
		return Nothing{};
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

} // namespace vp::picture
