#pragma once

#include "mesh/sheet_mesh.h"
#include "shared/render_types.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace vp::render
{

// Of one array, at the vertices or of the polygons; NaN where there is none. Empty: no values.
struct SurfaceValues
{
	std::span<const double> at_vertices{};
	std::span<const double> of_polygons{};
};

// What another process draws of the same surface.
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
	std::vector<glm::vec4> across{}; // of each triangle, where values are of polygons: those across its edges, 0
};

// A mesh's polygons as triangles, in parts of up to `most_texels` texels each of triangles and vertices (at least those
// of one polygon). A concave polygon is parted into triangles that cover it and nothing else, a bent one as it looks
// along its mean normal; diagonals are marked as no edges. A polygon with NaN at one of its vertices has no value. The
// last `polygons_elsewhere` are left out (SurfaceElsewhere).
std::vector<SurfacePart> surfaceTriangles(const mesh::SheetMesh& mesh, const SurfaceValues& values, const Vec3& origin,
                                          std::size_t most_texels, std::size_t polygons_elsewhere = 0);

} // namespace vp::render
