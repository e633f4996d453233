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
		gpu::TexelView across_texels; // with values of polygons
		std::uint32_t count = 0;      // of triangles
	};

	Vec3 origin{0.0}; // what vertices are kept from, in single precision
	std::vector<Part> parts;
	bool polygon_values = false; // values are of polygons, not at vertices
};

// Of a mesh in world coordinates; positions and polygons of it are used, nothing else. Fails where the device has no
// room. The device outlives it. elsewhere: null where no other process draws a part.
Result<std::shared_ptr<const SurfacePolygons>> surfacePolygons(gpu::Device& device, const mesh::SheetMesh& mesh,
                                                               const SurfaceValues& values = {},
                                                               const SurfaceElsewhere* elsewhere = nullptr);

} // namespace vp::render
