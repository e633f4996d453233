#pragma once

#include "mesh/sheet_mesh.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace vp::mesh
{

// Drops repeated vertices, and polygons without area. In a flat mesh the rest is turned to run counter-clockwise about
// `normal`; in others (see SheetMesh::flat) polygons keep their sense and `normal` means nothing.
void tidyPolygons(SheetMesh& mesh, const Vec3& normal = Vec3(0.0));

// The work that is left after the polygons are made, for the steps that look at the whole mesh.
struct MeshCleanup
{
	bool at_points = false; // vertices lie at grid points, so several may lie at one
	bool slivers = false;   // polygons may have no area, or repeat a vertex

	MeshCleanup operator|(const MeshCleanup& other) const
	{
		return {at_points || other.at_points, slivers || other.slivers};
	}
};

// Which way polygons in a plane run, seen along the axis that is nearest to its normal.
class Facing
{
public:
	explicit Facing(const Vec3& normal)
	{
		const Vec3 size = glm::abs(normal);
		const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
		u_ = (axis + 1) % 3;
		v_ = (axis + 2) % 3;
		sense_ = normal[axis] < 0.0 ? -1.0 : 1.0;
	}

	// Turns a polygon to run counter-clockwise about the normal. One that tidyPolygons() may have to do with is left as
	// it is, and the result is false. positions: of the vertices that it names.
	bool turn(const Vec3* positions, std::span<std::uint32_t> polygon) const;

private:
	// Well above the area that tidyPolygons() treats as zero. Seen along the axis, areas and distances are right within
	// a factor of two.
	static constexpr double kThin = 1e-12;

	int u_;
	int v_;
	double sense_;
};

inline bool Facing::turn(const Vec3* positions, std::span<std::uint32_t> polygon) const
{
	if (polygon.size() < 3)
		return false;
	const auto seen = [&](std::uint32_t v)
	{
		const double* xyz = glm::value_ptr(positions[v]);
		return glm::dvec2(xyz[u_], xyz[v_]);
	};
	const glm::dvec2 first = seen(polygon[0]);
	glm::dvec2 to_previous = seen(polygon[1]) - first;
	bool repeats = polygon[0] == polygon[1] || polygon[0] == polygon.back();
	double square = glm::dot(to_previous, to_previous); // squared distance of the farthest corner
	double area = 0.0;
	for (std::size_t v = 2; v < polygon.size(); ++v)
	{
		repeats = repeats || polygon[v] == polygon[v - 1];
		const glm::dvec2 to_next = seen(polygon[v]) - first;
		area += to_previous.x * to_next.y - to_previous.y * to_next.x;
		square = std::max(square, glm::dot(to_next, to_next));
		to_previous = to_next;
	}
	if (repeats || std::abs(area) <= kThin * square)
		return false;
	if (sense_ * area < 0.0)
		std::reverse(polygon.begin(), polygon.end());
	return true;
}

inline bool turnPolygon(const SheetMesh& mesh, const Vec3& normal, std::span<std::uint32_t> polygon)
{
	return Facing(normal).turn(mesh.positions.data(), polygon);
}

} // namespace vp::mesh
