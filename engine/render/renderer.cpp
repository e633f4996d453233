#include "gpu/vulkan.h"

#include "render/renderer.h"

#include "base/timeline.h"
#include "gpu/commands.h"
#include "gpu/timers.h"
#include "render/passes/compose_pass.h"
#include "render/passes/layer_pass.h"
#include "render/passes/line_pass.h"
#include "render/passes/overlay_pass.h"
#include "render/passes/picture_geometry.h"
#include "render/passes/raster_side.h"
#include "render/passes/surface_pass.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

// The device's picture is multiplied by alpha, as blending wants it; a file's is not.
void copyPixels(const gpu::Buffer& pixels, bool opaque, Picture& picture)
{
	pixels.invalidate();
	const auto* from = pixels.mappedAs<std::uint8_t>();
	picture.rgba.assign(from, from + std::size_t(4) * picture.width * picture.height);
	if (opaque)
		return;
	for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
	{
		const int alpha = picture.rgba[i + 3];
		if (alpha == 0 || alpha == 255)
			continue;
		for (int c = 0; c < 3; ++c)
			picture.rgba[i + c] =
			    static_cast<std::uint8_t>(std::min(255, (picture.rgba[i + c] * 255 + alpha / 2) / alpha));
	}
}

// Where a picture goes to: an image, or the host.
struct DrawTarget
{
	const gpu::Image* image = nullptr;
	const std::function<bool()>* goes_on = nullptr; // asked between samples, which are submitted one by one then
};

enum class Drawn
{
	whole,
	cramped, // fragments found no room; to be drawn again
	given_up
};

} // namespace

struct Renderer::Private
{
	gpu::Device& device;
	LayerPass layers;
	LinePass lines;
	SurfacePass surfaces;
	FragmentLists lists;
	ComposePass compose;
	OverlayPass overlay;
	gpu::Commands commands;
	gpu::Timers timers;
	Targets targets;
	std::size_t layers_drawn = 0;
	KeptLettering lettering{};

	// The targets hold nothing that can be left as it is.
	void forget()
	{
		layers.forget();
		lines.forget();
	}
	Status makeTargets(const Scene& scene);
	Status prepare(const Scene& scene);
	Result<Drawn> draw(const Scene& scene, const DrawTarget& target, Timeline* timeline);
	Result<Drawn> drawOnce(const Scene& scene, const DrawTarget& target, Timeline* timeline);
	Result<Drawn> finish(bool has_surfaces, Timeline* timeline);
	void recordSample(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	void recordSurfaces(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter, std::size_t sample);
	void recordPicture(VkCommandBuffer to, bool from_layers);
	void recordCopy(VkCommandBuffer to, const gpu::Image* into);
};

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
	    std::move(*compose), std::move(*overlay), std::move(*commands), gpu::Timers(device, "GPU draw"), Targets()}));
}

Status Renderer::Private::makeTargets(const Scene& scene)
{
	const VkExtent2D extent{scene.look.width, scene.look.height};
	const auto count = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(scene.sheets.size()));
	if (targets.holds(extent, count, scene.look.mesh))
		return Nothing{};
	forget();
	targets = {}; // before its successor, that both need not fit into memory
	auto made = Targets::create(device, extent, count, scene.look.mesh);
	if (!made)
		return made.error();
	targets = std::move(*made);
	return Nothing{};
}

Status Renderer::Private::prepare(const Scene& scene)
{
	const bool has_surfaces = !scene.surfaces.empty();
	if (has_surfaces)
	{
		if (Status ready = lists.prepare(targets.extent(), samplePattern(scene.look.samples).size()); !ready)
			return ready;
		if (Status ready = surfaces.prepare(scene, lists); !ready)
			return ready;
	}
	const Overlay over = makeOverlay(scene, &lettering);
	for (Status ready : {layers.prepare(scene, targets), lines.prepare(scene),
	                     compose.prepare(scene, targets, has_surfaces ? &lists : nullptr), overlay.prepare(over)})
		if (!ready)
			return ready;
	return Nothing{};
}

void Renderer::Private::recordSample(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                     std::size_t sample)
{
	{
		// Every sheet into its own layer of values, the outline into its depths.
		gpu::TimedPass timed(timers, to, "layers");
		layers_drawn += layers.record(to, scene, targets, jitter);
		lines.record(to, scene, targets, jitter);
	}
	if (composesWhole(scene))
		return;
	if (!scene.surfaces.empty())
		return recordSurfaces(to, scene, jitter, sample);
	// The layers in their order at each pixel, colored, blended and added to the samples before.
	gpu::TimedPass timed(timers, to, "compose");
	compose.record(to, targets, jitter, {{0, 0}, targets.extent()}, sample == 0, true);
}

void Renderer::Private::recordSurfaces(VkCommandBuffer to, const Scene& scene, const glm::dvec2& jitter,
                                       std::size_t sample)
{
	lists.recordSample(to);
	for (std::uint32_t strip = 0; strip < lists.strips(); ++strip)
	{
		{
			// Every surface into the lists of its pixels.
			gpu::TimedPass timed(timers, to, "surfaces");
			lists.recordBarrier(to);
			surfaces.record(to, scene, lists, jitter, sample, strip);
			lists.recordBarrier(to);
		}
		// Layers and lists in their order at each pixel, blended and added to the samples before.
		gpu::TimedPass timed(timers, to, "compose");
		compose.record(to, targets, jitter, lists.strip(strip), sample == 0, strip == 0);
	}
}

// From the sum of samples, or the layers of the only one, to pixels for the host.
void Renderer::Private::recordPicture(VkCommandBuffer to, bool from_layers)
{
	const VkExtent2D extent = targets.extent();
	targets.picture.transition(to, gpu::kDiscard, gpu::kColorTarget);
	if (from_layers)
	{
		// The layers in their order at each pixel, colored and blended over the background.
		gpu::TimedPass timed(timers, to, "compose");
		compose.recordWhole(to, targets);
		targets.picture.transition(to, gpu::kColorTarget, gpu::kColorTarget);
	}
	{
		// The samples' mean over the background, then legend, axes and words over the finished picture.
		gpu::TimedPass timed(timers, to, "overlay");
		if (!from_layers)
			targets.sum.transition(to, gpu::kColorTarget, gpu::kSampled);
		VkRenderingAttachmentInfo picture{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
		picture.imageView = targets.picture.view();
		picture.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
		picture.loadOp = from_layers ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
		picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
		VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
		rendering.renderArea.extent = extent;
		rendering.layerCount = 1;
		rendering.colorAttachmentCount = 1;
		rendering.pColorAttachments = &picture;
		vkCmdBeginRendering(to, &rendering);
		if (!from_layers)
			compose.recordResolve(to, targets);
		overlay.record(to, targets);
		vkCmdEndRendering(to);
		targets.picture.transition(to, gpu::kColorTarget, gpu::kCopyFrom);
	}
}

void Renderer::Private::recordCopy(VkCommandBuffer to, const gpu::Image* into)
{
	const VkExtent2D extent = targets.extent();
	gpu::TimedPass timed(timers, to, "copy");
	if (into)
	{
		VkImageCopy copy{};
		copy.srcSubresource = copy.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
		copy.extent = {extent.width, extent.height, 1};
		into->transition(to, gpu::kDiscard, gpu::kCopyTo);
		vkCmdCopyImage(to, targets.picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, into->handle(),
		               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
		return into->transition(to, gpu::kCopyTo, gpu::kCopyFrom);
	}
	VkBufferImageCopy copy{};
	copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
	copy.imageExtent = {extent.width, extent.height, 1};
	vkCmdCopyImageToBuffer(to, targets.picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, targets.pixels.handle(),
	                       1, &copy);
	gpu::memoryBarrier(to, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_HOST_BIT,
	                   VK_ACCESS_2_HOST_READ_BIT);
}

// What is recorded, done.
Result<Drawn> Renderer::Private::finish(bool has_surfaces, Timeline* timeline)
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
	if (!has_surfaces)
		return Drawn::whole;
	Result<bool> complete = lists.complete();
	if (!complete)
		return complete.error();
	return *complete ? Drawn::whole : Drawn::cramped;
}

Result<Drawn> Renderer::Private::drawOnce(const Scene& scene, const DrawTarget& target, Timeline* timeline)
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
		recordSample(*begun, scene, pattern[sample], sample);
	}
	if (has_surfaces)
		lists.recordEnd(*begun);
	recordPicture(*begun, composesWhole(scene));
	recordCopy(*begun, target.image);
	return finish(has_surfaces, timeline);
}

Result<Drawn> Renderer::Private::draw(const Scene& scene, const DrawTarget& target, Timeline* timeline)
{
	if (scene.sheets.size() > shared::kMaxLayers)
		return Error{ErrorKind::usage, fmt::format("{} sheets are more than a picture takes; show up to {}",
		                                           scene.sheets.size(), shared::kMaxLayers)};
	if (Status made = makeTargets(scene); !made)
		return made.error();
	layers_drawn = 0;
	for (;;)
		if (Result<Drawn> drawn = drawOnce(scene, target, timeline); !drawn || *drawn != Drawn::cramped)
			return drawn;
}

std::size_t Renderer::layersDrawn() const
{
	return private_->layers_drawn;
}

Result<Picture> Renderer::draw(const Scene& scene, Timeline* timeline)
{
	const TimedSection section(timeline, "draw");
	if (Result<Drawn> drawn = private_->draw(scene, {}, timeline); !drawn)
		return drawn.error();
	const TimedSection reading(timeline, "pixels");
	Picture picture{scene.look.width, scene.look.height, {}};
	const Background& background = scene.look.background;
	copyPixels(private_->targets.pixels, background.top.a == 255 && background.bottom.a == 255, picture);
	return picture;
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
