#include "render/passes/surface_polygons.h"

#include "gpu/upload.h"

#include <algorithm>

namespace vp::render
{

namespace
{

// 64 MiB of triangles, and no more vertices than have numbers below kHiddenEdge.
constexpr std::size_t kPartTexels = std::size_t(1) << 22;

Status fill(gpu::Device& device, std::span<const std::byte> bytes, VkFormat format, gpu::Buffer& buffer,
            gpu::TexelView& texels, const char* name)
{
	auto made = gpu::uploaded(device, bytes, VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT, name);
	if (!made)
		return made.error();
	buffer = std::move(*made);
	auto view = gpu::TexelView::create(buffer, format, name);
	if (!view)
		return view.error();
	texels = std::move(*view);
	return Nothing{};
}

} // namespace

Result<std::shared_ptr<const SurfacePolygons>> surfacePolygons(gpu::Device& device, const mesh::SheetMesh& mesh,
                                                               const SurfaceValues& values,
                                                               const SurfaceElsewhere* elsewhere)
{
	auto made = std::make_shared<SurfacePolygons>();
	made->polygon_values = !values.of_polygons.empty();
	Box box;
	for (const Vec3& p : mesh.positions)
		box.include(p);
	if (elsewhere)
		made->origin = elsewhere->origin;
	else if (!box.empty())
		made->origin = box.center();
	// A buffer may become a little longer than it was asked for (gpu/workarounds.h).
	constexpr std::size_t kLonger = 64;
	const std::size_t texels = std::min<std::size_t>(kPartTexels, device.limits().maxTexelBufferElements - kLonger);
	for (const SurfacePart& part :
	     surfaceTriangles(mesh, values, made->origin, texels, elsewhere ? elsewhere->polygons : 0))
	{
		SurfacePolygons::Part& on_device = made->parts.emplace_back();
		on_device.count = static_cast<std::uint32_t>(part.triangles.size());
		if (Status filled = fill(device, std::as_bytes(std::span(part.triangles)), VK_FORMAT_R32G32B32A32_UINT,
		                         on_device.triangles, on_device.triangle_texels, "surface triangles");
		    !filled)
			return filled.error();
		if (Status filled = fill(device, std::as_bytes(std::span(part.vertices)), VK_FORMAT_R32G32B32A32_SFLOAT,
		                         on_device.vertices, on_device.vertex_texels, "surface vertices");
		    !filled)
			return filled.error();
		if (!made->polygon_values)
			continue;
		if (Status filled = fill(device, std::as_bytes(std::span(part.across)), VK_FORMAT_R32G32B32A32_SFLOAT,
		                         on_device.across, on_device.across_texels, "surface values across");
		    !filled)
			return filled.error();
	}
	return std::shared_ptr<const SurfacePolygons>(std::move(made));
}

} // namespace vp::render
