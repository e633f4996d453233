#include "gpu/vulkan.h"

#include "render/renderer.h"

#include "base/timeline.h"
#include "gpu/commands.h"
#include "gpu/timers.h"
#include "render/compose_pass.h"
#include "render/layer_pass.h"
#include "render/line_pass.h"
#include "render/overlay_pass.h"
#include "render/picture_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace vp::render
{

namespace
{

// The device's picture is multiplied by alpha, as blending wants it; a file's is not.
void copyPixels(const gpu::Buffer& pixels, Picture& picture)
{
	pixels.invalidate();
	picture.rgba.resize(std::size_t(4) * picture.width * picture.height);
	std::memcpy(picture.rgba.data(), pixels.mapped(), picture.rgba.size());
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

} // namespace

struct Renderer::Private
{
	gpu::Device& device;
	LayerPass layers;
	LinePass lines;
	ComposePass compose;
	OverlayPass overlay;
	gpu::Commands commands;
	gpu::Timers timers;
	Targets targets;
};

Renderer::Renderer(std::unique_ptr<Private> made) : private_(std::move(made)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Result<Renderer> Renderer::create(gpu::Device& device)
{
	auto layers = LayerPass::create(device);
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
	return Renderer(std::unique_ptr<Private>(new Private{device, std::move(*layers), std::move(*lines),
	                                                     std::move(*compose), std::move(*overlay), std::move(*commands),
	                                                     gpu::Timers(device), Targets()}));
}

Result<Picture> Renderer::draw(const Scene& scene, Timeline* timeline)
{
	const TimedSection section(timeline, "draw");
	Private& r = *private_;
	if (scene.sheets.size() > shared::kMaxLayers)
		return Error{ExitCode::usage, fmt::format("{} sheets are more than a picture takes; show up to {}",
		                                          scene.sheets.size(), shared::kMaxLayers)};
	const VkExtent2D extent{scene.look.width, scene.look.height};
	const auto layers = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(scene.sheets.size()));
	if (!r.targets.holds(extent, layers, scene.look.mesh))
	{
		r.targets = {}; // before its successor, that both need not fit into memory
		auto targets = Targets::create(r.device, extent, layers, scene.look.mesh);
		if (!targets)
			return targets.error();
		r.targets = std::move(*targets);
	}
	{
		const Overlay overlay = makeOverlay(scene);
		for (Status ready : {r.layers.prepare(scene), r.lines.prepare(scene), r.compose.prepare(scene, r.targets),
		                     r.overlay.prepare(overlay)})
			if (!ready)
				return ready.error();
	}

	auto begun = r.commands.begin();
	if (!begun)
		return begun.error();
	const VkCommandBuffer commands = *begun;
	const auto pattern = samplePattern(scene.look.samples);
	for (std::size_t sample = 0; sample < pattern.size(); ++sample)
	{
		{
			// Every sheet into its own layer of values, the outline into its depths.
			gpu::TimedPass timed(r.timers, commands, "layers");
			r.layers.record(commands, scene, r.targets, pattern[sample]);
			r.lines.record(commands, scene, r.targets, pattern[sample]);
		}
		// The layers in their order at each pixel, coloured, blended and added to the samples before.
		gpu::TimedPass timed(r.timers, commands, "compose");
		r.compose.record(commands, r.targets, pattern[sample], sample == 0);
	}
	{
		// The samples' mean over the background, then legend, axes and words over the finished picture.
		gpu::TimedPass timed(r.timers, commands, "overlay");
		r.targets.sum.transition(commands, gpu::kColourTarget, gpu::kSampled);
		r.targets.picture.transition(commands, gpu::kDiscard, gpu::kColourTarget);
		VkRenderingAttachmentInfo picture{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
		picture.imageView = r.targets.picture.view();
		picture.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
		picture.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
		picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
		VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
		rendering.renderArea.extent = extent;
		rendering.layerCount = 1;
		rendering.colorAttachmentCount = 1;
		rendering.pColorAttachments = &picture;
		vkCmdBeginRendering(commands, &rendering);
		r.compose.recordResolve(commands, r.targets);
		r.overlay.record(commands, r.targets);
		vkCmdEndRendering(commands);
		r.targets.picture.transition(commands, gpu::kColourTarget, gpu::kCopyFrom);
	}
	{
		gpu::TimedPass timed(r.timers, commands, "copy");
		VkBufferImageCopy copy{};
		copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
		copy.imageExtent = {extent.width, extent.height, 1};
		vkCmdCopyImageToBuffer(commands, r.targets.picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
		                       r.targets.pixels.handle(), 1, &copy);
		gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
		                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
	}
	const Status drawn = r.commands.submitAndWait();
	if (!drawn)
	{
		r.timers.forget();
		return drawn.error();
	}
	if (timeline)
		r.timers.collect(*timeline);
	else
		r.timers.forget();

	Picture picture{extent.width, extent.height, {}};
	copyPixels(r.targets.pixels, picture);
	return picture;
}

} // namespace vp::render
