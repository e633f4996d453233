#include "ranks/picture/joined_surfaces.h"

#include "ranks/join/polygons_around.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace vp::ranks
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
Result<std::shared_ptr<const render::SurfacePolygons>> polygonsOf(gpu::Device& device, const cut::SheetCut& sheet,
                                                                  std::span<const GrownContour> contours, bool colored)
{
	JoinedContours joined(sheet);
	for (const GrownContour& contour : contours)
		joined.addPolygons(contour.mesh, joined.addVertices(contour.mesh, contour.value), 0, contour.mesh.polygons());
	if (joined.mesh.polygons() == 0)
		return std::shared_ptr<const render::SurfacePolygons>();
	return polygonsOf(device, joined, colored, nullptr);
}

// The same for one of several ranks: polygons of other ranks have a part in how those beside them look, and stand last.
Result<std::shared_ptr<const render::SurfacePolygons>> polygonsOfRank(Team& team, gpu::Device& device,
                                                                      const cut::SheetCut& sheet,
                                                                      std::span<const GrownContour> contours,
                                                                      bool colored)
{
	JoinedContours joined(sheet);
	Box box;
	std::vector<std::pair<mesh::SheetMesh, std::uint32_t>> around; // and the first vertex
	for (const GrownContour& contour : contours)
	{
		mesh::SheetMesh mesh = contour.mesh;
		std::vector<double> none;
		addPolygonsAround(team, contour.borders, mesh, none);
		const std::uint32_t first = joined.addVertices(mesh, contour.value);
		for (std::size_t v = 0; v < contour.mesh.positions.size(); ++v)
			box.include(joined.mesh.positions[first + v]);
		joined.addPolygons(mesh, first, 0, contour.mesh.polygons());
		around.emplace_back(std::move(mesh), first);
	}
	sumOverAll(team, box, [](Box& all, const Box& other) { all.include(other); });
	if (box.empty())
		return std::shared_ptr<const render::SurfacePolygons>();
	const std::size_t own = joined.mesh.polygons();
	for (std::size_t c = 0; c < contours.size(); ++c)
		joined.addPolygons(around[c].first, around[c].second, contours[c].mesh.polygons(), around[c].first.polygons());
	const render::SurfaceElsewhere elsewhere{.origin = box.center(), .polygons = joined.mesh.polygons() - own};
	return polygonsOf(device, joined, colored, &elsewhere);
}

} // namespace

Result<std::shared_ptr<const render::SurfacePolygons>>
surfacePolygons(const Ranks& ranks, gpu::Device& device, const mesh::SheetMesh& mesh, const Borders& borders,
                render::SheetValues values, const mesh::PartEdges& part_edges)
{
	if (!ranks.team())
		return render::surfacePolygons(device, mesh, {values.of_vertices, values.of_polygons, &part_edges});
	Box box;
	for (const Vec3& place : mesh.positions)
		box.include(place);
	sumOverAll(*ranks.team(), box, [](Box& all, const Box& other) { all.include(other); });
	mesh::SheetMesh around = mesh;
	render::SurfaceElsewhere elsewhere{.origin = box.empty() ? Vec3(0.0) : box.center()};
	elsewhere.polygons = addPolygonsAround(*ranks.team(), borders, around, values.of_polygons);
	if (!values.of_vertices.empty())
		values.of_vertices.resize(around.positions.size(), 0.0);
	// The other ranks' polygons stand last, so the marks of this one's are at their places.
	return render::surfacePolygons(device, around, {values.of_vertices, values.of_polygons, &part_edges}, &elsewhere);
}

Result<std::shared_ptr<const render::SurfacePolygons>> contourPolygons(const Ranks& ranks, gpu::Device& device,
                                                                       const cut::SheetCut& sheet,
                                                                       std::span<const GrownContour> contours,
                                                                       bool colored)
{
	return ranks.team() ? polygonsOfRank(*ranks.team(), device, sheet, contours, colored)
	                    : polygonsOf(device, sheet, contours, colored);
}

Result<std::shared_ptr<const render::SurfacePolygons>> surfaceOfFirst(const Ranks& ranks, gpu::Device& device,
                                                                      const mesh::SheetMesh& mesh,
                                                                      const render::SurfaceValues& values)
{
	if (!ranks.team())
		return render::surfacePolygons(device, mesh, values);
	Box box;
	for (const Vec3& place : mesh.positions)
		box.include(place);
	const render::SurfaceElsewhere elsewhere{.origin = box.empty() ? Vec3(0.0) : box.center()};
	return ranks.isFirst() ? render::surfacePolygons(device, mesh, values, &elsewhere)
	                       : render::surfacePolygons(device, {}, {}, &elsewhere);
}

} // namespace vp::ranks
