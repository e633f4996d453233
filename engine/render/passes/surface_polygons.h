#pragma once

#include "gpu/buffer.h"
#include "render/passes/surface_triangles.h"

#include <memory>

namespace vp::render
{

// A surface's polygons in device memory: 32 bytes a triangle (48 with values of polygons), 16 a vertex. They may be
// drawn in any number of pictures.
struct SurfacePolygons
{
	struct Part
	{
		gpu::Buffer triangles;
		gpu::Buffer vertices;
		gpu::Buffer across;
		gpu::TexelView triangle_texels;
		gpu::TexelView vertex_texels;
		gpu::TexelView across_texels; // only if values belong to polygons
		std::uint32_t count = 0;      // number of triangles
	};

	Vec3 origin{0.0}; // origin of the vertices, which are kept in single precision
	std::vector<Part> parts;
	bool polygon_values = false; // values belong to polygons, not to vertices
};

// Returns the polygons of a mesh in world coordinates. Only the mesh's positions and polygons are used. Fails if the
// device has no room. The device must outlive the result. elsewhere: null if no other process draws a part.
Result<std::shared_ptr<const SurfacePolygons>> surfacePolygons(gpu::Device& device, const mesh::SheetMesh& mesh,
                                                               const SurfaceValues& values = {},
                                                               const SurfaceElsewhere* elsewhere = nullptr);

} // namespace vp::render
