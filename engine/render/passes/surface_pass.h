#pragma once

#include "gpu/shader.h"
#include "render/passes/buffers.h"
#include "render/passes/fragment_lists.h"
#include "render/passes/opaque_target.h"
#include "render/passes/surface_culling.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <map>
#include <optional>
#include <vector>

namespace vp::render
{

// Draws the scene's surfaces, colored already. Those that hide all that is behind them go into one image with a depth
// test (render_surface_opaque.frag). The fragments of the others that are not hidden so go into lists, one at each
// pixel (render_surface.frag).
class SurfacePass
{
public:
	explicit SurfacePass(gpu::Device& device) : device_(&device), culling_(device) {}

	// `lists` must be prepared, and so must `mask`, which is null for a picture of one sample. A scene without surfaces
	// does not call this, and then nothing is made. More surfaces than shared::kMaxSurfaces are a usage error, and so
	// is a device without fragmentStoresAndAtomics.
	Status prepare(const Scene& scene, const FragmentLists& lists, const EdgeMask* mask);
	// recordOpaque() makes the depths, and draws the opaque surfaces if there are any. Then recordLists() draws the
	// others, strip by strip. edges: as OpaqueTarget::recordBegin() takes it.
	void recordOpaque(VkCommandBuffer commands, const Scene& scene, const PicturePart& part, const glm::dvec2& jitter,
	                  const EdgeMask* edges) const;
	// After the mask was drawn: what later samples draw of the opaque surfaces.
	void recordNearEdges(VkCommandBuffer commands, const Scene& scene, const PicturePart& part) const;
	void recordLists(VkCommandBuffer commands, const Scene& scene, const PicturePart& part, const FragmentLists& lists,
	                 const glm::dvec2& jitter, std::size_t sample, std::uint32_t strip) const;

	// Return whether the scene prepared last has opaque surfaces, and the target that they are drawn into.
	bool hasOpaque() const { return has_opaque_; }
	const OpaqueTarget& opaque() const { return opaque_; }

private:
	struct Style
	{
		std::uint32_t features = 0;
		bool is_opaque = false;

		auto operator<=>(const Style&) const = default;
	};

	Status putColors(const Scene& scene);
	Result<const gpu::Pipeline*> pipelineFor(const Style& style);
	Status writeSets(const Scene& scene, const FragmentLists& lists);
	void record(VkCommandBuffer commands, const Scene& scene, const PicturePart& part, const glm::dvec2& jitter,
	            bool opaque, bool culled, shared::SurfacePush push) const;

	gpu::Device* device_;
	std::map<Style, gpu::Pipeline> pipelines_;
	std::vector<Style> styles_; // styles of the surfaces prepared last
	bool has_opaque_ = false;
	OpaqueTarget opaque_;
	SurfaceCulling culling_;
	std::optional<gpu::DescriptorSets> sets_;
	std::vector<VkDescriptorSet> part_sets_; // in the order of surfaces and their parts
	gpu::Buffer params_;
	HostTexels tables_;
};

} // namespace vp::render
