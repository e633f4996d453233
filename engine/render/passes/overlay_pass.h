#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/annotate/overlay.h"
#include "render/passes/targets.h"

namespace vp::render
{

// Draws the overlay's triangles over the picture, at its full resolution.
class OverlayPass
{
public:
	static Result<OverlayPass> create(gpu::Device& device);

	Status prepare(const Overlay& overlay);
	// Within a rendering into the picture.
	void record(VkCommandBuffer commands, const Targets& targets) const;

private:
	Status putLetters(const std::shared_ptr<const FontAtlas>& lettering);

	gpu::Device* device_ = nullptr;
	gpu::Pipeline pipeline_;
	gpu::DescriptorSets sets_;
	gpu::Sampler sampler_;
	gpu::Image letters_;
	std::shared_ptr<const FontAtlas> lettering_; // whose they are
	gpu::Buffer vertices_;
	gpu::Buffer indices_;
	VkDescriptorSet set_ = VK_NULL_HANDLE;
	std::uint32_t count_ = 0;
};

} // namespace vp::render
