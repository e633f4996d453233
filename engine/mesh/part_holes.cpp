#include "mesh/part_holes.h"

#include "mesh/bridges.h"
#include "mesh/polygon_fans.h"

namespace vp::mesh
{

namespace
{

// The places of a polygon's corners along two axes at right angles to its normal, counter-clockwise.
std::vector<glm::dvec2> flattened(const SheetMesh& mesh, std::span<const std::uint32_t> polygon)
{
	const Vec3 area = doubleArea(mesh, polygon);
	const double length = glm::length(area);
	const Vec3 normal = length > 0.0 ? area / length : Vec3(0.0, 0.0, 1.0);
	const Vec3 x_axis =
	    glm::normalize(glm::cross(std::abs(normal.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0), normal));
	const Vec3 y_axis = glm::cross(normal, x_axis);
	std::vector<glm::dvec2> places;
	for (const std::uint32_t v : polygon)
	{
		const Vec3 way = mesh.positions[v] - mesh.positions[polygon[0]];
		places.emplace_back(glm::dot(way, x_axis), glm::dot(way, y_axis));
	}
	return places;
}

} // namespace

std::optional<SheetMesh> partHoles(const SheetMesh& mesh)
{
	std::vector<std::size_t> with_holes;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		if (!bridgesOf(mesh.polygon(p)).empty())
			with_holes.push_back(p);
	if (with_holes.empty())
		return std::nullopt;
	SheetMesh parted = mesh;
	parted.polygon_starts.assign(1, 0);
	parted.polygon_vertices.clear();
	parted.polygon_cells.clear();
	const auto end = [&](std::size_t p)
	{
		parted.polygon_starts.push_back(static_cast<std::uint32_t>(parted.polygon_vertices.size()));
		parted.polygon_cells.push_back(mesh.polygon_cells[p]);
	};
	auto next = with_holes.begin();
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		if (p == mesh.polygons() - mesh.boundary_polygons)
			parted.boundary_polygons = parted.polygons(); // before them
		const std::span<const std::uint32_t> polygon = mesh.polygon(p);
		if (next == with_holes.end() || *next != p)
		{
			parted.polygon_vertices.insert(parted.polygon_vertices.end(), polygon.begin(), polygon.end());
			end(p);
			continue;
		}
		++next;
		for (const std::vector<std::uint32_t>& fan : cutIntoFans(flattened(mesh, polygon)))
		{
			for (const std::uint32_t corner : fan)
				parted.polygon_vertices.push_back(polygon[corner]);
			end(p);
		}
	}
	if (mesh.boundary_polygons > 0)
		parted.boundary_polygons = parted.polygons() - parted.boundary_polygons;
	return parted;
}

} // namespace vp::mesh
