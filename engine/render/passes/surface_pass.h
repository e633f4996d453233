#pragma once

#include "gpu/shader.h"
#include "render/passes/fragment_lists.h"
#include "render/passes/host_buffer.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <map>
#include <optional>
#include <vector>

namespace vp::render
{

// Draws the scene's surfaces into lists of fragments, colored already, one at each pixel (render_surface.frag).
class SurfacePass
{
public:
	explicit SurfacePass(gpu::Device& device) : device_(&device) {}

	// `lists` must be prepared. A scene without surfaces does not call this, and then nothing is made. More surfaces
	// than shared::kMaxSurfaces are a usage error, and so is a device without fragmentStoresAndAtomics.
	Status prepare(const Scene& scene, const FragmentLists& lists);
	void record(VkCommandBuffer commands, const Scene& scene, const FragmentLists& lists, const glm::dvec2& jitter,
	            std::size_t sample, std::uint32_t strip) const;

private:
	Status putColors(const Scene& scene);
	Result<const gpu::Pipeline*> pipelineFor(std::uint32_t features);
	Status writeSets(const Scene& scene, const FragmentLists& lists);

	gpu::Device* device_;
	std::map<std::uint32_t, gpu::Pipeline> pipelines_; // by features
	std::vector<std::uint32_t> features_;              // of the surfaces prepared last
	std::optional<gpu::DescriptorSets> sets_;
	std::vector<VkDescriptorSet> part_sets_; // in the order of surfaces and their parts
	gpu::Buffer params_;
	HostTexels tables_;
};

} // namespace vp::render
