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
	std::size_t polygons = 0;
	const std::size_t of_cells = mesh.polygons() - mesh.boundary_polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const std::size_t begin = kept.size();
		for (const std::uint32_t v : mesh.polygon(p))
			if (kept.size() == begin || kept.back() != v)
				kept.push_back(v);
		while (kept.size() > begin + 1 && kept.back() == kept[begin])
			kept.pop_back();

		const std::span polygon = std::span(kept).subspan(begin);
		// Rounding leaves a section that is a line with an area of some 1e-16 of its length squared.
		constexpr double kNoArea = 1e-15;
		double longest = 0.0;
		for (const std::uint32_t v : polygon)
			longest = std::max(longest, glm::length(mesh.positions[v] - mesh.positions[polygon[0]]));
		const double area = polygon.size() < 3 ? 0.0 : doubleAreaOf(mesh, polygon, normal);
		if (std::abs(area) <= kNoArea * longest * longest)
		{
			kept.resize(begin);
			mesh.boundary_polygons -= p >= of_cells;
			continue;
		}
		if (area < 0.0)
			std::reverse(polygon.begin(), polygon.end());
		mesh.polygon_cells[polygons++] = mesh.polygon_cells[p];
		starts.push_back(static_cast<std::uint32_t>(kept.size()));
	}
	mesh.polygon_cells.resize(polygons);
	mesh.polygon_starts = std::move(starts);
	mesh.polygon_vertices = std::move(kept);
}

} // namespace vp::mesh
