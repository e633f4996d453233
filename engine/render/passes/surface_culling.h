#pragma once

#include "gpu/shader.h"
#include "render/passes/edge_mask.h"
#include "render/passes/opaque_target.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <span>
#include <vector>

namespace vp::render
{

// Finds the triangles of opaque surfaces that later samples of a picture may show: those that touch a pixel at an edge
// and are not hidden there (render_surface_cull.comp). A software device takes half a microsecond for each triangle
// that it draws, seen or not.
class SurfaceCulling
{
public:
	explicit SurfaceCulling(gpu::Device& device) : device_(&device) {}

	// Call it before recording, while no submission draws. surfaces: indices of the opaque surfaces. mask: null for a
	// picture with one sample. If culling does not pay, on hardware and for few triangles, isUsed() is false
	// afterwards.
	Status prepare(const Scene& scene, std::span<const std::size_t> surfaces, const EdgeMask* mask,
	               const OpaqueTarget& opaque);
	bool isUsed() const { return !runs_.empty(); }

	// After the first sample and the mask were drawn.
	void record(VkCommandBuffer commands, const Scene& scene, const PicturePart& part) const;
	// Within a rendering, with the surface's pipeline bound: the triangles of a part of a surface that were found.
	void recordDraw(VkCommandBuffer commands, std::size_t surface, std::size_t part) const;

private:
	struct Run // a part of a surface
	{
		std::size_t surface;
		std::size_t part;
		std::uint32_t count;
		std::uint32_t first_word;
		std::uint32_t first_index;
		VkDescriptorSet set = VK_NULL_HANDLE;
	};

	Status makePipelines();
	Status makeBuffers(std::uint32_t words, std::uint32_t triangles);
	Status writeSets(const Scene& scene, const EdgeMask& mask, const OpaqueTarget& opaque);

	gpu::Device* device_;
	gpu::Pipeline cull_;
	gpu::Pipeline list_;
	gpu::DescriptorSets cull_sets_;
	gpu::DescriptorSets list_sets_;
	gpu::Sampler sampler_;
	gpu::Buffer kept_; // a bit a triangle
	gpu::TexelView kept_texels_;
	gpu::Buffer indices_;
	gpu::Buffer draws_;
	std::uint32_t words_ = 0;
	std::vector<Run> runs_;
	VkDescriptorSet list_set_ = VK_NULL_HANDLE;
};

} // namespace vp::render
