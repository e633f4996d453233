#include "gpu/vulkan.h"

#include "render/renderer_parts.h"

#include "base/messages.h"
#include "base/timeline.h"
#include "render/passes/picture_geometry.h"
#include "render/passes/raster_side.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

Renderer::Renderer(std::unique_ptr<Private> made) : private_(std::move(made)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Result<Renderer> Renderer::create(gpu::Device& device, std::uint64_t most_fragment_bytes,
                                  std::optional<std::uint32_t> raster_side)
{
	auto side = raster_side ? Result<std::uint32_t>(*raster_side) : suitableRasterSide(device);
	if (!side)
		return side.error();
	auto layers = LayerPass::create(device, *side);
	if (!layers)
		return layers.error();
	auto lines = LinePass::create(device);
	if (!lines)
		return lines.error();
	auto mask = EdgeMask::create(device);
	if (!mask)
		return mask.error();
	auto quads = EdgeQuads::create(device);
	if (!quads)
		return quads.error();
	auto compose = ComposePass::create(device);
	if (!compose)
		return compose.error();
	auto overlay = OverlayPass::create(device);
	if (!overlay)
		return overlay.error();
	auto commands = gpu::Commands::create(device, "render");
	if (!commands)
		return commands.error();
	return Renderer(std::unique_ptr<Private>(new Private{
	    device, std::move(*layers), std::move(*lines), SurfacePass(device), FragmentLists(device, most_fragment_bytes),
	    std::move(*mask), std::move(*quads), std::move(*compose), std::move(*overlay), std::move(*commands),
	    gpu::Timers(device, "GPU draw"), Targets(), most_fragment_bytes}));
}

Status Renderer::Private::makeTargets(const Scene& scene)
{
	const std::uint64_t for_lists = std::min<std::uint64_t>(most_fragment_bytes, device.memoryBudget() / 4);
	auto planned = planPicture(device, scene, for_lists);
	if (!planned)
		return planned.error();
	plan = *planned;
	lists.limit(for_lists);
	const auto count = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(scene.sheets.size()));
	const bool sum = !composesWhole(device, scene, plan.first);
	if (targets.holds(plan.first, count, scene.look.mesh, sum))
		return Nothing{};
	if (!plan.first.isWhole())
		warn("{}", describe(plan, device, scene));
	forget();
	targets = {}; // before its successor, that both need not fit into memory
	if (sum)
		quads.release();
	auto made = Targets::create(device, plan.first, count, scene.look.mesh, sum);
	if (!made)
		return made.error();
	targets = std::move(*made);
	return Nothing{};
}

Status Renderer::Private::prepare(const Scene& scene)
{
	const bool has_surfaces = !scene.surfaces.empty();
	const bool has_edges = samplePattern(scene.look.samples).size() > 1;
	whole = composesWhole(device, scene, targets.part());
	const EdgeTiles* edges = !has_edges ? nullptr : whole ? &quads.tiles() : &mask.tiles();
	if (has_edges)
	{
		const std::uint32_t reach = contourReach(scene.look);
		if (Status ready = whole ? quads.prepare(targets, reach) : mask.prepare(targets, reach); !ready)
			return ready;
	}
	if (has_surfaces)
	{
		if (Status ready = lists.prepare(targets.extent(), samplePattern(scene.look.samples).size()); !ready)
			return ready;
		if (Status ready = prepareSurfaces(scene); !ready)
			return ready;
	}
	const Overlay over = makeOverlay(scene, &lettering);
	for (Status ready : {layers.prepare(scene, targets, edges), lines.prepare(scene, whole ? edges : nullptr),
	                     prepareComposing(scene), overlay.prepare(over)})
		if (!ready)
			return ready;
	return Nothing{};
}

Status Renderer::Private::prepareSurfaces(const Scene& scene)
{
	return surfaces.prepare(scene, lists, samplePattern(scene.look.samples).size() > 1 ? &mask : nullptr);
}

Status Renderer::Private::prepareComposing(const Scene& scene)
{
	const bool has_edges = samplePattern(scene.look.samples).size() > 1;
	const ComposePass::SurfaceTargets drawn_surfaces{lists, surfaces.opaque(), surfaces.hasOpaque()};
	return compose.prepare(scene, targets, scene.surfaces.empty() ? nullptr : &drawn_surfaces,
	                       {has_edges && !whole ? &mask : nullptr, has_edges && whole ? &quads : nullptr});
}

void Renderer::Private::recordSample(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                     std::size_t sample)
{
	const EdgeTiles* later = sample == 0 ? nullptr : whole ? &quads.tiles() : &mask.tiles();
	{
		// Every sheet into its own layer of values, the outline into its depths.
		gpu::TimedPass timed(timers, to, "layers");
		layers_drawn += layers.record(to, scene, targets, jitter, later);
		lines.record(to, scene, targets, jitter, whole ? later : nullptr);
	}
	recordColors(to, scene, jitter, sample);
}

void Renderer::Private::recordColors(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                     std::size_t sample)
{
	if (whole)
		return recordWhole(to, scene, jitter, sample);
	if (!scene.surfaces.empty())
		return recordSurfaces(to, scene, jitter, sample);
	// The layers in their order at each pixel, colored, blended and added to the samples before.
	gpu::TimedPass timed(timers, to, "compose");
	compose.record(to, targets, jitter, {{0, 0}, targets.extent()}, sample > 0 ? &mask : nullptr, true);
}

// The layers in their order at each pixel, colored and blended over the background: straight into the picture.
void Renderer::Private::recordWhole(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                    std::size_t sample)
{
	gpu::TimedPass timed(timers, to, "compose");
	if (sample > 0)
		return compose.recordQuads(to, quads, jitter, sample, samplePattern(scene.look.samples).size());
	targets.picture.transition(to, gpu::kDiscard, gpu::kColorTarget);
	compose.recordWhole(to, targets, jitter);
}

void Renderer::Private::recordSurfaces(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                       std::size_t sample)
{
	const EdgeMask* later = sample > 0 ? &mask : nullptr;
	lists.recordSample(to);
	{
		// Opaque surfaces, the nearest at each pixel.
		gpu::TimedPass timed(timers, to, "surfaces");
		surfaces.recordOpaque(to, scene, targets.part(), jitter, later);
	}
	for (std::uint32_t strip = 0; strip < lists.strips(); ++strip)
	{
		{
			// The others into the lists of their pixels.
			gpu::TimedPass timed(timers, to, "surfaces");
			lists.recordBarrier(to);
			surfaces.recordLists(to, scene, targets.part(), lists, jitter, sample, strip);
			lists.recordBarrier(to);
		}
		// Layers and lists in their order at each pixel, blended and added to the samples before.
		gpu::TimedPass timed(timers, to, "compose");
		compose.record(to, targets, jitter, lists.strip(strip), later, strip == 0);
	}
}

// From the sum of samples to pixels of the picture, unless they are there already. The words come with the last part.
void Renderer::Private::recordPicture(VkCommandBuffer to, bool has_edges, std::uint32_t part)
{
	const bool is_last = part + 1 == plan.count();
	targets.picture.transition(to,
	                           whole && has_edges  ? gpu::kStorage
	                           : whole || part > 0 ? gpu::kColorTarget
	                                               : gpu::kDiscard,
	                           gpu::kColorTarget);
	{
		// The samples' mean over the background, then legend, axes and words over the finished picture.
		gpu::TimedPass timed(timers, to, "overlay");
		if (!whole)
			targets.sum.transition(to, gpu::kColorTarget, gpu::kSampled);
		VkRenderingAttachmentInfo picture{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
		picture.imageView = targets.picture.view();
		picture.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
		picture.loadOp = whole || part > 0 ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
		picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
		VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
		rendering.renderArea.extent = plan.first.picture;
		rendering.layerCount = 1;
		rendering.colorAttachmentCount = 1;
		rendering.pColorAttachments = &picture;
		vkCmdBeginRendering(to, &rendering);
		if (!whole)
			compose.recordResolve(to, targets, plan.shown(part));
		if (is_last)
			overlay.record(to, targets);
		vkCmdEndRendering(to);
	}
	if (is_last)
		targets.picture.transition(to, gpu::kColorTarget, gpu::kCopyFrom);
}

// Submits the recorded commands and waits for them.
Result<Drawn> Renderer::Private::finish(bool counts_fragments, Timeline* timeline)
{
	const Status drawn = [&]
	{
		const TimedSection section(timeline, "wait");
		return commands.submitAndWait();
	}();
	if (!drawn)
		forget();
	if (drawn && timeline)
		timers.collect(*timeline);
	else
		timers.forget();
	if (!drawn)
		return drawn.error();
	if (!counts_fragments)
		return Drawn::whole;
	Result<bool> complete = lists.complete();
	if (!complete)
		return complete.error();
	return *complete ? Drawn::whole : Drawn::cramped;
}

Result<Drawn> Renderer::Private::drawOnce(const Scene& scene, const DrawTarget& target, std::uint32_t part,
                                          Timeline* timeline)
{
	const bool has_surfaces = !scene.surfaces.empty();
	{
		const TimedSection section(timeline, "prepare");
		if (Status ready = prepare(scene); !ready)
			return ready.error();
	}
	auto begun = commands.begin();
	if (!begun)
		return begun.error();
	if (has_surfaces)
		lists.recordStart(*begun);
	const auto pattern = samplePattern(scene.look.samples);
	for (std::size_t sample = 0; sample < pattern.size(); ++sample)
	{
		if (target.goes_on && sample > 0)
		{
			if (Status done = commands.submitAndWait(); !done)
			{
				forget();
				timers.forget();
				return done.error();
			}
			if (*target.goes_on && !(*target.goes_on)())
			{
				timers.forget();
				return Drawn::given_up;
			}
			begun = commands.begin();
			if (!begun)
				return begun.error();
		}
		if (target.merge)
		{
			const Result<bool> goes_on = mergeSample(scene, pattern[sample], sample, *target.merge);
			if (!goes_on)
				forget();
			if (!goes_on || (!*goes_on && sample + 1 == pattern.size()))
			{
				timers.forget();
				return goes_on ? Result<Drawn>(Drawn::given_up) : goes_on.error();
			}
			if (!*goes_on)
				continue;
		}
		else
			recordSample(*begun, scene, pattern[sample], sample);
		if (sample == 0 && pattern.size() > 1)
		{
			// Finds where the other samples are needed.
			gpu::TimedPass timed(timers, *begun, "edges");
			if (whole)
				quads.record(*begun, targets);
			else
				mask.record(*begun, targets);
			if (has_surfaces && !target.merge)
				surfaces.recordNearEdges(*begun, scene, targets.part());
		}
	}
	const bool counts_fragments = has_surfaces && !target.merge; // others have been counted sample by sample
	if (counts_fragments)
		lists.recordEnd(*begun);
	recordPicture(*begun, pattern.size() > 1, part);
	if (part + 1 == plan.count())
	{
		gpu::TimedPass timed(timers, *begun, "copy");
		targets.recordCopy(*begun, target.image);
	}
	return finish(counts_fragments, timeline);
}

Result<Drawn> Renderer::Private::draw(const Scene& scene, const DrawTarget& target, Timeline* timeline)
{
	if (scene.sheets.size() > shared::kMaxLayers)
		return Error{ErrorKind::usage, fmt::format("{} sheets are more than a picture takes; show up to {}",
		                                           scene.sheets.size(), shared::kMaxLayers)};
	if (Status made = makeTargets(scene); !made)
		return made.error();
	layers_drawn = 0;
	if (target.merge && plan.count() > 1)
		return Error{ErrorKind::usage,
		             "`size`: pictures of several processes are drawn in one part; make it smaller, or use vprobe"};
	for (std::uint32_t part = 0; part < plan.count(); ++part)
	{
		if (target.goes_on && *target.goes_on && !(*target.goes_on)())
			return Drawn::given_up;
		targets.setFirstRow(plan.firstRow(part));
		Result<Drawn> drawn = Drawn::cramped;
		while (drawn && *drawn == Drawn::cramped)
			drawn = drawOnce(scene, target, part, timeline);
		if (!drawn || *drawn != Drawn::whole)
			return drawn;
	}
	return Drawn::whole;
}

Picture Renderer::Private::pictureOf(const Look& look, Timeline* timeline) const
{
	const TimedSection reading(timeline, "pixels");
	const bool is_opaque = look.background.top.a == 255 && look.background.bottom.a == 255;
	return {look.width, look.height, targets.readPixels(is_opaque)};
}

std::size_t Renderer::layersDrawn() const
{
	return private_->layers_drawn;
}

Result<Picture> Renderer::draw(const Scene& scene, Timeline* timeline, const std::function<bool()>& goes_on)
{
	const TimedSection section(timeline, "draw");
	Result<Drawn> drawn = private_->draw(scene, {nullptr, goes_on ? &goes_on : nullptr}, timeline);
	if (!drawn)
		return drawn.error();
	if (*drawn == Drawn::given_up)
		return Error{ErrorKind::cancelled, "drawing was cancelled"};
	return private_->pictureOf(scene.look, timeline);
}

Result<std::optional<Picture>> Renderer::drawMerged(const Scene& scene, const MergeLayers& merge, Timeline* timeline)
{
	const TimedSection section(timeline, "draw");
	Result<Drawn> drawn = private_->draw(scene, {nullptr, nullptr, &merge}, timeline);
	if (!drawn)
		return drawn.error();
	return *drawn == Drawn::whole ? std::optional(private_->pictureOf(scene.look, timeline)) : std::nullopt;
}

Result<bool> Renderer::drawInto(const Scene& scene, const gpu::Image& into, const std::function<bool()>& goes_on,
                                Timeline* timeline)
{
	const TimedSection section(timeline, "draw");
	Result<Drawn> drawn = private_->draw(scene, {&into, &goes_on}, timeline);
	if (!drawn)
		return drawn.error();
	return *drawn == Drawn::whole;
}

} // namespace vp::render
