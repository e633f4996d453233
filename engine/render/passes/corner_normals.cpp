#include "render/passes/corner_normals.h"

#include "mesh/seam_names.h"
#include "render/scene/feature_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace vp::render
{

namespace
{

// The polygons about each vertex, one list after the other.
struct PolygonsAbout
{
	std::vector<std::uint32_t> starts;
	std::vector<std::uint32_t> polygons;

	PolygonsAbout(const mesh::SheetMesh& mesh, const mesh::SeamNames& names)
	    : starts(mesh.positions.size() + 2), polygons(mesh.polygon_vertices.size())
	{
		// Counted one place on, so that filling moves each start to where it belongs.
		for (const std::uint32_t v : mesh.polygon_vertices)
			++starts[names[v] + 2];
		for (std::size_t i = 2; i < starts.size(); ++i)
			starts[i] += starts[i - 1];
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
			for (const std::uint32_t v : mesh.polygon(p))
				polygons[starts[names[v] + 1]++] = static_cast<std::uint32_t>(p);
	}
	// Sums of floats depend on their order; so it is that of the areas, and not of the polygons.
	void sortBy(const std::vector<Vec3f>& areas)
	{
		const auto key = [&](std::uint32_t p) { return std::tuple(areas[p].x, areas[p].y, areas[p].z); };
		for (std::size_t v = 0; v + 2 < starts.size(); ++v)
			std::sort(polygons.begin() + starts[v], polygons.begin() + starts[v + 1],
			          [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
	}
	std::span<const std::uint32_t> operator[](std::uint32_t v) const
	{
		return std::span(polygons).subspan(starts[v], starts[v + 1] - starts[v]);
	}
};

Vec3f unit(const Vec3f& v)
{
	const float length = glm::length(v);
	return length > 0.0f ? v / length : Vec3f(0.0f);
}

} // namespace

std::vector<Vec3f> cornerNormals(const mesh::SheetMesh& mesh)
{
	const auto cosine = static_cast<float>(std::cos(kFeatureAngle * std::numbers::pi / 180.0));
	std::vector<Vec3f> areas;
	areas.reserve(mesh.polygons());
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		areas.emplace_back(mesh::doubleArea(mesh, mesh.polygon(p)));
	const mesh::SeamNames names(mesh);
	PolygonsAbout about(mesh, names);
	about.sortBy(areas);
	std::vector<Vec3f> normals;
	normals.reserve(mesh.polygon_vertices.size());
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const Vec3f own = unit(areas[p]);
		for (const std::uint32_t v : mesh.polygon(p))
		{
			Vec3f sum(0.0f);
			for (const std::uint32_t other : about[names[v]])
			{
				const float along = glm::dot(areas[other], own);
				if (std::abs(along) >= cosine * glm::length(areas[other]))
					sum += along < 0.0f ? -areas[other] : areas[other];
			}
			normals.push_back(unit(sum));
		}
	}
	return normals;
}

} // namespace vp::render
