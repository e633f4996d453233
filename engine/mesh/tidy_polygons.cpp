#include "mesh/tidy_polygons.h"

#include <algorithm>
#include <cmath>

namespace vp::mesh
{

namespace
{

// Negative where the polygon is to be turned.
double doubleAreaOf(const SheetMesh& mesh, std::span<const std::uint32_t> polygon, const Vec3& normal)
{
	// Along the normal: what a line's rounding adds to it points anywhere.
	if (mesh.flat)
		return glm::dot(doubleArea(mesh, polygon), normal);
	double area = 0.0;
	forFan(mesh, polygon, [&](std::uint32_t, std::uint32_t, double part) { area += 2.0 * std::abs(part); });
	return area;
}

} // namespace

void tidyPolygons(SheetMesh& mesh, const Vec3& normal)
{
	RawVector<std::uint32_t> starts{0};
	RawVector<std::uint32_t> kept;
	kept.reserve(mesh.polygon_vertices.size());
	const bool has_added = !mesh.is_added.empty();
	std::vector<std::uint8_t> is_added; // as in the mesh
	is_added.reserve(mesh.is_added.size());
	// A corner of the polygon's own stays one if a join has put the same vertex beside it.
	const auto isRepeated = [&](std::size_t own, std::size_t other)
	{
		if (has_added && kept[own] == kept[other])
			is_added[own] = is_added[own] && is_added[other];
		return kept[own] == kept[other];
	};
	std::size_t polygons = 0;
	const std::size_t of_cells = mesh.polygons() - mesh.boundary_polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const std::size_t begin = kept.size();
		const auto drop = [&](std::size_t from)
		{
			kept.resize(from);
			is_added.resize(has_added ? from : 0);
		};
		for (std::uint32_t corner = mesh.polygon_starts[p]; corner < mesh.polygon_starts[p + 1]; ++corner)
		{
			kept.push_back(mesh.polygon_vertices[corner]);
			if (has_added)
				is_added.push_back(mesh.is_added[corner]);
			if (kept.size() > begin + 1 && isRepeated(kept.size() - 2, kept.size() - 1))
				drop(kept.size() - 1);
		}
		while (kept.size() > begin + 1 && isRepeated(begin, kept.size() - 1))
			drop(kept.size() - 1);

		const std::span polygon = std::span(kept).subspan(begin);
		// Rounding leaves a section that is a line with an area of some 1e-16 of its length squared.
		constexpr double kNoArea = 1e-15;
		double longest = 0.0;
		for (const std::uint32_t v : polygon)
			longest = std::max(longest, glm::length(mesh.positions[v] - mesh.positions[polygon[0]]));
		const double area = polygon.size() < 3 ? 0.0 : doubleAreaOf(mesh, polygon, normal);
		if (std::abs(area) <= kNoArea * longest * longest)
		{
			drop(begin);
			mesh.boundary_polygons -= p >= of_cells;
			continue;
		}
		if (area < 0.0)
		{
			std::reverse(polygon.begin(), polygon.end());
			if (has_added)
				std::reverse(is_added.begin() + static_cast<std::ptrdiff_t>(begin), is_added.end());
		}
		mesh.polygon_cells[polygons++] = mesh.polygon_cells[p];
		starts.push_back(static_cast<std::uint32_t>(kept.size()));
	}
	mesh.polygon_cells.resize(polygons);
	mesh.polygon_starts = std::move(starts);
	mesh.polygon_vertices = std::move(kept);
	mesh.is_added = std::move(is_added);
}

} // namespace vp::mesh
