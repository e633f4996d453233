#pragma once

#include "gpu/commands.h"
#include "gpu/timers.h"
#include "render/passes/compose_pass.h"
#include "render/passes/edge_mask.h"
#include "render/passes/edge_quads.h"
#include "render/passes/layer_merge.h"
#include "render/passes/layer_pass.h"
#include "render/passes/line_pass.h"
#include "render/passes/overlay_pass.h"
#include "render/passes/picture_memory.h"
#include "render/passes/surface_merge.h"
#include "render/passes/surface_pass.h"
#include "render/renderer.h"

namespace vp::render
{

// Where a picture goes to: an image, or the host.
struct DrawTarget
{
	const gpu::Image* image = nullptr;
	const std::function<bool()>* goes_on = nullptr; // asked between samples, which are submitted one by one then
	const MergeLayers* merge = nullptr;             // takes in what others have drawn of each layer
};

enum class Drawn
{
	whole,
	cramped, // fragments found no room; to be drawn again
	given_up
};

struct Renderer::Private
{
	gpu::Device& device;
	LayerPass layers;
	LinePass lines;
	SurfacePass surfaces;
	FragmentLists lists;
	EdgeMask mask;
	EdgeQuads quads;
	ComposePass compose;
	OverlayPass overlay;
	gpu::Commands commands;
	gpu::Timers timers;
	Targets targets;
	std::uint64_t most_fragment_bytes;
	PicturePlan plan{};
	bool whole = false; // composesWhole()
	std::size_t layers_drawn = 0;
	KeptLettering lettering{};
	LayerMerge merger{};
	SurfaceMerge surface_merger{};

	// The targets hold nothing that can be left as it is.
	void forget()
	{
		layers.forget();
		lines.forget();
	}
	Status makeTargets(const Scene& scene);
	Status prepare(const Scene& scene);
	Status prepareSurfaces(const Scene& scene);
	Status prepareComposing(const Scene& scene);
	Result<Drawn> draw(const Scene& scene, const DrawTarget& target, Timeline* timeline);
	Result<Drawn> drawOnce(const Scene& scene, const DrawTarget& target, std::uint32_t part, Timeline* timeline);
	Result<Drawn> finish(bool counts_fragments, Timeline* timeline);
	void recordSample(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	void recordSurfaces(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	void recordWhole(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	void recordPicture(VkCommandBuffer to, bool has_edges, std::uint32_t part);
	void recordColors(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	Result<bool> mergeSample(const Scene& scene, const glm::dvec2& jitter, std::size_t sample,
	                         const MergeLayers& merge);
	Result<SurfaceFragments> takeSurfaces(const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	Status composeSurfaces(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample,
	                       const SurfaceFragments& fragments);
	Picture pictureOf(const Look& look, Timeline* timeline) const;
};

} // namespace vp::render
