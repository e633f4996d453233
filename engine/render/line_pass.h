#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/scene.h"
#include "render/targets.h"

namespace vp::render
{

// Draws the outline and the windows' rims into a depth image: near / w of the nearest line at each pixel, 0 where there
// is none.
class LinePass
{
public:
	static Result<LinePass> create(gpu::Device& device);

	Status prepare(const Scene& scene);
	void record(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter) const;

private:
	gpu::Device* device_ = nullptr;
	gpu::Pipeline pipeline_;
	gpu::DescriptorSets sets_;
	gpu::Buffer segments_;
	VkDescriptorSet set_ = VK_NULL_HANDLE;
	Vec3 centre_{0.0}; // that the segments are relative to
	std::uint32_t count_ = 0;
};

} // namespace vp::render
