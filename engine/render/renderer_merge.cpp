#include "gpu/vulkan.h"

#include "render/renderer_parts.h"

namespace vp::render
{

// Draws a sample with what others have drawn. Returns false if another process goes on.
Result<bool> Renderer::Private::mergeSample(const Scene& scene, const glm::dvec2& jitter, std::size_t sample,
                                            const MergeLayers& merge)
{
	const bool has_surfaces = !scene.surfaces.empty();
	layers.forget(); // what they hold came from others too
	layers_drawn += layers.record(commands.handle(), scene, targets, jitter);
	SurfaceFragments fragments;
	if (has_surfaces)
	{
		auto taken = takeSurfaces(scene, jitter, sample);
		if (!taken)
			return taken.error();
		fragments = std::move(*taken);
	}
	auto merged = merger.run(device, commands, targets, static_cast<std::uint32_t>(scene.sheets.size()),
	                         has_surfaces ? &fragments : nullptr, merge);
	if (!merged)
		return merged.error();
	if (*merged == VK_NULL_HANDLE)
		return false;
	lines.record(*merged, scene, targets, jitter, sample > 0 && whole ? &quads.tiles() : nullptr);
	if (!has_surfaces)
		recordColors(*merged, scene, jitter, sample);
	else if (Status composed = composeSurfaces(*merged, scene, jitter, sample, fragments); !composed)
		return composed.error();
	return true;
}

// Draws the surfaces of a sample, all over the picture: others do not know where edges are.
Result<SurfaceFragments> Renderer::Private::takeSurfaces(const Scene& scene, const glm::dvec2& jitter,
                                                         std::size_t sample)
{
	for (;;)
	{
		const VkCommandBuffer to = commands.handle();
		lists.recordStart(to);
		lists.recordSample(to);
		surfaces.recordOpaque(to, scene, targets.part(), jitter, nullptr);
		lists.recordBarrier(to);
		surfaces.recordLists(to, scene, targets.part(), lists, jitter, sample, 0);
		lists.recordBarrier(to);
		lists.recordEnd(to);
		if (Status recorded = surface_merger.recordTaking(device, to, lists, surfaces); !recorded)
			return recorded.error();
		if (Status done = commands.submitAndWait(); !done)
			return done.error();
		if (Result<VkCommandBuffer> begun = commands.begin(); !begun)
			return begun.error();
		const Result<bool> complete = lists.complete();
		if (!complete)
			return complete.error();
		if (*complete)
			return surface_merger.taken(surfaces);
		if (lists.strips() > 1)
			return Error{ErrorKind::out_of_memory, "`size`: the surfaces have more fragments than the device has room "
			                                       "for; make it smaller, or use vprobe"};
		for (Status ready : {prepareSurfaces(scene), prepareComposing(scene)})
			if (!ready)
				return ready.error();
	}
}

// The layers and the fragments of all processes in their order at each pixel.
Status Renderer::Private::composeSurfaces(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                          std::size_t sample, const SurfaceFragments& fragments)
{
	const Result<bool> grown = lists.makeRoom(fragments.listed.size());
	if (!grown)
		return grown.error();
	if (*grown)
		for (Status ready : {prepareSurfaces(scene), prepareComposing(scene)})
			if (!ready)
				return ready;
	if (Status put = surface_merger.recordPutting(device, to, fragments, lists, surfaces); !put)
		return put;
	gpu::TimedPass timed(timers, to, "compose");
	compose.record(to, targets, jitter, lists.strip(0), sample > 0 ? &mask : nullptr, true);
	return Nothing{};
}

} // namespace vp::render
