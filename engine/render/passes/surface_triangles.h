#pragma once

#include "mesh/part_edges.h"
#include "mesh/sheet_mesh.h"
#include "shared/render_types.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace vp::render
{

// The values of one array, at the vertices or of the polygons; NaN if there is no value. Empty: no values.
struct SurfaceValues
{
	std::span<const double> at_vertices{};
	std::span<const double> of_polygons{};
	const mesh::PartEdges* part_edges = nullptr; // edges that are not drawn
};

// The part of the same surface that another process draws.
struct SurfaceElsewhere
{
	Vec3 origin{0.0};         // the same for all
	std::size_t polygons = 0; // the mesh's last ones: they bend normals and have values across edges, and are not drawn
};

// A part of a surface as the device takes it: triangles and the vertices they name (x, y, z from the surface's origin,
// value).
struct SurfacePart
{
	std::vector<shared::SurfaceTriangle> triangles;
	std::vector<glm::vec4> vertices;
	std::vector<glm::vec4> across{}; // per triangle, if values belong to polygons: values across its edges, 0
};

// Returns a mesh's polygons as triangles, in parts. Each part has up to `most_texels` texels of triangles and of
// vertices, and at least one polygon. A concave polygon is split into triangles that cover it and nothing else; a bent
// one is split as it looks along its mean normal. Diagonals are marked as no edges. A polygon with NaN at one of its
// vertices has no value. The last `polygons_elsewhere` polygons are left out (SurfaceElsewhere).
std::vector<SurfacePart> surfaceTriangles(const mesh::SheetMesh& mesh, const SurfaceValues& values, const Vec3& origin,
                                          std::size_t most_texels, std::size_t polygons_elsewhere = 0);

} // namespace vp::render
