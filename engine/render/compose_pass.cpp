#include "gpu/vulkan.h"

#include "render/compose_pass.h"

#include "render/host_buffer.h"
#include "render/picture_geometry.h"

#include <algorithm>
#include <limits>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::ComposeParams) == 4 * (13 + 12 + 4 * shared::kMaxLayers + kColorMapSize));

// Interpolation rounds; it must not take the ends of the range out of it.
constexpr double kRangeSlack = 1e-5;

constexpr Color kPlainSheet{142, 168, 195}; // where there is no array to show
constexpr Color kLineOnLight{66, 72, 82, 225};
constexpr Color kLineOnDark{206, 211, 218, 225};

std::uint32_t packed(Color c)
{
	return c.r | std::uint32_t(c.g) << 8 | std::uint32_t(c.b) << 16 | std::uint32_t(c.a) << 24;
}

void store(float (&to)[4], Color c)
{
	const std::uint8_t from[] = {c.r, c.g, c.b, c.a};
	for (int i = 0; i < 4; ++i)
		to[i] = static_cast<float>(from[i]) / 255.0f;
}

VkPipelineColorBlendAttachmentState summing()
{
	VkPipelineColorBlendAttachmentState state = gpu::premultipliedOver();
	state.dstColorBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
	return state;
}

void fill(shared::ComposeParams& params, const Scene& scene, VkExtent2D extent)
{
	params = {};
	params.height = static_cast<float>(extent.height);
	params.sample_weight = 1.0f / static_cast<float>(samplePattern(scene.look.samples).size());
	params.last_layer = static_cast<std::uint32_t>(scene.sheets.empty() ? 0 : scene.sheets.size() - 1);
	const Look& look = scene.look;
	params.below_from = -std::numeric_limits<float>::infinity();
	params.above_from = std::numeric_limits<float>::infinity();
	if (scene.values)
	{
		const auto [lo, hi] = colorRange(*scene.values, look);
		params.has_values = 1;
		params.range_lo = static_cast<float>(lo);
		if (look.range)
		{
			const double slack = kRangeSlack * (hi - lo);
			params.below_from = static_cast<float>(lo - slack);
			params.above_from = static_cast<float>(hi + slack);
		}
		// A constant has the map's middle.
		const bool constant = !(hi > lo);
		params.range_scale = constant ? 0.0f : static_cast<float>(1.0 / (hi - lo));
		params.range_offset = constant ? 0.5f : 0.0f;
	}
	params.nan_color = packed(look.colors.nan);
	params.below_color = packed(look.colors.below);
	params.above_color = packed(look.colors.above);
	params.plain_color = packed(kPlainSheet);
	store(params.line_color, look.background.dark() ? kLineOnDark : kLineOnLight);
	store(params.top_color, look.background.top);
	store(params.bottom_color, look.background.bottom);
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const auto depth = planeDepth(scene.sheets[i].sheet, scene.camera, extent);
		std::transform(depth.begin(), depth.end(), params.plane + 4 * i,
		               [](double d) { return static_cast<float>(d); });
		params.plane[4 * i + 3] = static_cast<float>(std::clamp(scene.sheets[i].opacity, 0.0, 1.0));
	}
	std::transform(look.colors.colors.begin(), look.colors.colors.end(), params.colors, packed);
}

} // namespace

Result<ComposePass> ComposePass::create(gpu::Device& device)
{
	gpu::GraphicsPipelineInfo info;
	info.vertex_shader = "render_full.vert";
	info.fragment_shader = "render_compose.frag";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
	                 {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
	info.push_bytes = sizeof(shared::ComposePush);
	info.colour_formats = {sumFormat(device)};
	info.blends = {summing()};
	ComposePass pass;
	pass.device_ = &device;
	for (std::size_t i = 0; i < kSlots.size(); ++i)
	{
		info.constants = {{0, kSlots[i]}};
		auto pipeline = gpu::Pipeline::create(device, info, "compose");
		if (!pipeline)
			return pipeline.error();
		pass.pipelines_[i] = std::move(*pipeline);
	}
	gpu::GraphicsPipelineInfo resolve;
	resolve.vertex_shader = "render_full.vert";
	resolve.fragment_shader = "render_resolve.frag";
	resolve.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER}, {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
	resolve.colour_formats = {kPictureFormat};
	auto resolve_pipeline = gpu::Pipeline::create(device, resolve, "resolve");
	if (!resolve_pipeline)
		return resolve_pipeline.error();
	pass.resolve_ = std::move(*resolve_pipeline);
	pass.resolve_sets_ = gpu::DescriptorSets(device, pass.resolve_, "resolve");
	auto sampler = gpu::Sampler::create(device, VK_FILTER_NEAREST, "layers");
	if (!sampler)
		return sampler.error();
	pass.sampler_ = std::move(*sampler);
	// The pipelines' layouts are alike, so a set fits them all.
	pass.sets_ = gpu::DescriptorSets(device, pass.pipelines_[0], "compose");
	return pass;
}

const gpu::Pipeline& ComposePass::pipelineFor(std::size_t layers) const
{
	std::size_t i = 0;
	while (kSlots[i] < layers)
		++i;
	return pipelines_[i];
}

Status ComposePass::prepare(const Scene& scene, const Targets& targets)
{
	if (Status room = makeRoom(*device_, params_, sizeof(shared::ComposeParams), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
	                           "compose parameters");
	    !room)
		return room;
	fill(*params_.mappedAs<shared::ComposeParams>(), scene, targets.extent());
	params_.flush();
	layers_ = scene.sheets.size();
	auto set = sets_.get(0);
	if (!set)
		return set.error();
	set_ = *set;
	gpu::DescriptorWriter()
	    .uniformBuffer(0, params_.handle())
	    .sampledImage(1, targets.layers(), sampler_.handle())
	    .sampledImage(2, targets.lines.view(), sampler_.handle())
	    .write(*device_, set_);
	auto resolve_set = resolve_sets_.get(0);
	if (!resolve_set)
		return resolve_set.error();
	resolve_set_ = *resolve_set;
	gpu::DescriptorWriter()
	    .uniformBuffer(0, params_.handle())
	    .sampledImage(1, targets.sum.view(), sampler_.handle())
	    .write(*device_, resolve_set_);
	return Nothing{};
}

void ComposePass::record(VkCommandBuffer commands, const Targets& targets, const glm::dvec2& jitter, bool first) const
{
	targets.sum.transition(commands, first ? gpu::kDiscard : gpu::kColourTarget, gpu::kColourTarget);
	VkRenderingAttachmentInfo sum{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	sum.imageView = targets.sum.view();
	sum.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
	sum.loadOp = first ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
	sum.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea.extent = targets.extent();
	rendering.layerCount = 1;
	rendering.colorAttachmentCount = 1;
	rendering.pColorAttachments = &sum;
	vkCmdBeginRendering(commands, &rendering);
	coverAll(commands, targets.extent());
	const gpu::Pipeline& pipeline = pipelineFor(layers_);
	pipeline.bind(commands, set_);
	pipeline.push(commands, shared::ComposePush{{static_cast<float>(jitter.x), static_cast<float>(jitter.y)}});
	vkCmdDraw(commands, 3, 1, 0, 0);
	vkCmdEndRendering(commands);
}

void ComposePass::recordResolve(VkCommandBuffer commands, const Targets& targets) const
{
	coverAll(commands, targets.extent());
	resolve_.bind(commands, resolve_set_);
	vkCmdDraw(commands, 3, 1, 0, 0);
}

} // namespace vp::render
