#include "gpu/vulkan.h"

#include "render/passes/compose_pass.h"

#include "render/passes/compose_params.h"
#include "render/passes/picture_geometry.h"
#include "render/passes/sheet_regions.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace vp::render
{

namespace
{

VkPipelineColorBlendAttachmentState summing()
{
	VkPipelineColorBlendAttachmentState state = gpu::premultipliedOver();
	state.dstColorBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
	return state;
}

shared::ComposePush showing(std::span<const std::uint32_t> sheets)
{
	shared::ComposePush push{};
	push.layers = static_cast<std::uint32_t>(sheets.size());
	for (std::size_t slot = 0; slot < sheets.size(); ++slot)
		push.slots[slot / 8] |= sheets[slot] << 4 * (slot % 8);
	return push;
}

} // namespace

bool composesWhole(const gpu::Device& device, const Scene& scene, const PicturePart& part)
{
	return part.isWhole() && scene.surfaces.empty() &&
	       (samplePattern(scene.look.samples).size() == 1 || EdgeQuads::fits(device, part.extent));
}

Result<ComposePass> ComposePass::create(gpu::Device& device)
{
	ComposePass pass;
	pass.device_ = &device;
	// The layouts of pipelines without surfaces are alike, so a set of the first fits them all.
	auto first = pass.pipelinesFor(1, 0, false, {});
	if (!first)
		return first.error();
	pass.sets_ = gpu::DescriptorSets(device, (*first)->everywhere, "compose");
	(*first)->lends_layout = true;
	gpu::GraphicsPipelineInfo resolve;
	resolve.vertex_shader = "render_full.vert";
	resolve.fragment_shader = "render_resolve.frag";
	resolve.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
	                    {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                    {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
	resolve.push_bytes = sizeof(shared::ResolvePush);
	resolve.color_formats = {kPictureFormat};
	auto resolve_pipeline = gpu::Pipeline::create(device, resolve, "resolve");
	if (!resolve_pipeline)
		return resolve_pipeline.error();
	pass.resolve_ = std::move(*resolve_pipeline);
	pass.resolve_sets_ = gpu::DescriptorSets(device, pass.resolve_, "resolve");
	auto sampler = gpu::Sampler::create(device, VK_FILTER_NEAREST, "layers");
	if (!sampler)
		return sampler.error();
	pass.sampler_ = std::move(*sampler);
	return pass;
}

// Someone who tries out all settings would gather hundreds, of a megabyte or more each.
void ComposePass::forgetOldPipelines()
{
	constexpr std::size_t most = 32;
	while (pipelines_.size() > most)
	{
		auto oldest = pipelines_.end();
		for (auto each = pipelines_.begin(); each != pipelines_.end(); ++each)
			if (!each->second.lends_layout &&
			    (oldest == pipelines_.end() || each->second.last_scene < oldest->second.last_scene))
				oldest = each;
		pipelines_.erase(oldest);
	}
}

Result<ComposePass::Pipelines*> ComposePass::pipelinesFor(std::size_t layers, std::uint32_t features, bool surfaces,
                                                          const Edges& edges)
{
	const std::uint32_t slots = *std::find_if(kSlots.begin(), kSlots.end(), [&](auto s) { return s >= layers; });
	Pipelines& pipelines = pipelines_[{slots, features, surfaces}];
	pipelines.last_scene = scenes_;
	for (const bool at_edges : {false, true})
	{
		gpu::Pipeline& pipeline = at_edges ? pipelines.at_edges : pipelines.everywhere;
		if (pipeline || (at_edges && !edges.mask))
			continue;
		auto made = makePipeline(slots, features, surfaces, at_edges);
		if (!made)
			return made.error();
		pipeline = std::move(*made);
	}
	if (edges.quads && !pipelines.quads)
	{
		auto made = makeQuadsPipeline(slots, features);
		if (!made)
			return made.error();
		pipelines.quads = std::move(*made);
	}
	return &pipelines;
}

Result<gpu::Pipeline> ComposePass::makeQuadsPipeline(std::uint32_t slots, std::uint32_t features) const
{
	gpu::ComputePipelineInfo info;
	info.shader = "render_compose_quads.comp";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},         {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {3, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {4, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},   {5, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {6, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},         {7, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}};
	info.push_bytes = sizeof(shared::ComposePush);
	info.constants = {{0, slots}, {1, features}};
	return gpu::Pipeline::create(*device_, info, "compose at edges");
}

Result<gpu::Pipeline> ComposePass::makePipeline(std::uint32_t slots, std::uint32_t features, bool surfaces,
                                                bool at_edges) const
{
	gpu::GraphicsPipelineInfo info;
	info.vertex_shader = "render_full.vert";
	info.fragment_shader = surfaces ? "render_compose_surfaces.frag" : "render_compose.frag";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
	                 {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {3, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {4, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}};
	if (surfaces)
	{
		info.bindings.push_back({5, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE});
		info.bindings.push_back({6, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER});
		info.bindings.push_back({7, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER});
		info.bindings.push_back({8, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER});
	}
	info.push_bytes = sizeof(shared::ComposePush);
	const bool whole = (features & shared::kComposeWhole) != 0;
	info.color_formats = {whole ? kPictureFormat : sumFormat(*device_)};
	if (!whole)
		info.blends = {summing()};
	info.constants = {{0, slots}, {1, features}};
	if (at_edges)
	{
		info.depth_format = kDepthFormat;
		info.depth_test = true;
		info.depth_compare = VK_COMPARE_OP_GREATER_OR_EQUAL; // compares the 0 of render_full.vert with the mask
	}
	return gpu::Pipeline::create(*device_, info, "compose");
}

Result<VkDescriptorSet> ComposePass::compositionSet(const Targets& targets, const SurfaceTargets* surfaces)
{
	if (surfaces && !surface_sets_)
	{
		surface_sets_.emplace(*device_, pipelines_in_use_->everywhere, "compose surfaces");
		pipelines_in_use_->lends_layout = true;
	}
	auto set = surfaces ? surface_sets_->get(0) : sets_.get(0);
	if (!set)
		return set;
	gpu::DescriptorWriter writer;
	writer.uniformBuffer(0, params_.handle())
	    .sampledImage(1, targets.layers(), sampler_.handle())
	    .sampledImage(2, targets.lines.view(), sampler_.handle())
	    .texels(3, tables_.texels.handle())
	    .texels(4, colors_.texels.handle());
	if (surfaces)
		writer.storageImage(5, surfaces->lists.heads().view())
		    .texels(6, surfaces->lists.fragmentTexels())
		    .sampledImage(7, surfaces->opaque.nearest().view(), sampler_.handle())
		    .sampledImage(8, surfaces->opaque.depth().view(), sampler_.handle(), OpaqueTarget::kDepthLayout);
	writer.write(*device_, *set);
	return set;
}

Status ComposePass::prepare(const Scene& scene, const Targets& targets, const SurfaceTargets* surfaces,
                            const Edges& edges)
{
	// The picture that was prepared before has been drawn.
	++scenes_;
	forgetOldPipelines();
	const ComposeParams made = composeParams(scene, targets.part());
	if (Status room = makeRoom(*device_, params_, sizeof(shared::ComposeParams), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
	                           "compose parameters");
	    !room)
		return room;
	*params_.mappedAs<shared::ComposeParams>() = made.params;
	params_.flush();
	if (Status put = tables_.put(*device_, std::as_bytes(std::span(made.tables)), VK_FORMAT_R32_UINT, "color tables");
	    !put)
		return put;
	if (Status put =
	        colors_.put(*device_, std::as_bytes(std::span(made.colors)), VK_FORMAT_R32G32_UINT, "layers' colors");
	    !put)
		return put;
	const std::uint32_t features = made.features |
	                               (composesWhole(*device_, scene, targets.part()) ? shared::kComposeWhole : 0u) |
	                               (surfaces && surfaces->has_opaque ? shared::kComposeOpaque : 0u);
	auto pipelines = pipelinesFor(std::max<std::size_t>(1, scene.sheets.size()), features, surfaces != nullptr, edges);
	if (!pipelines)
		return pipelines.error();
	pipelines_in_use_ = *pipelines;
	std::vector<std::uint32_t> all(scene.sheets.size());
	std::iota(all.begin(), all.end(), 0u);
	all_sheets_ = showing(all);
	regions_.clear();
	if (!surfaces)
		if (Status ready = prepareRegions(scene, targets, features, edges); !ready)
			return ready;
	auto set = compositionSet(targets, surfaces);
	if (!set)
		return set.error();
	set_ = *set;
	if (edges.quads)
		return writeQuadsSet(targets, *edges.quads);
	return (features & shared::kComposeWhole) != 0 ? Status(Nothing{}) : writeResolveSet(targets, edges.mask);
}

Status ComposePass::prepareRegions(const Scene& scene, const Targets& targets, std::uint32_t features,
                                   const Edges& edges)
{
	for (const SheetRegion& region : sheetRegions(scene, targets.part()))
	{
		const bool ground = region.sheets.empty();
		auto pipelines = pipelinesFor(std::max<std::size_t>(1, region.sheets.size()),
		                              ground ? (features & shared::kComposeWhole) | shared::kComposeGround : features,
		                              false, {edges.mask, nullptr});
		if (!pipelines)
			return pipelines.error();
		regions_.push_back({region.pixels, *pipelines, showing(region.sheets)});
	}
	return Nothing{};
}

Status ComposePass::writeQuadsSet(const Targets& targets, const EdgeQuads& quads)
{
	if (!quads_sets_)
	{
		quads_sets_.emplace(*device_, pipelines_in_use_->quads, "compose at edges");
		pipelines_in_use_->lends_layout = true;
	}
	auto set = quads_sets_->get(0);
	if (!set)
		return set.error();
	quads_set_ = *set;
	gpu::DescriptorWriter()
	    .uniformBuffer(0, params_.handle())
	    .sampledImage(1, targets.layers(), sampler_.handle())
	    .sampledImage(2, targets.lines.view(), sampler_.handle())
	    .texels(3, tables_.texels.handle())
	    .texels(4, colors_.texels.handle())
	    .storageBuffer(5, quads.listed().handle())
	    .storageBuffer(6, quads.sums().handle())
	    .storageImage(7, targets.picture.view())
	    .write(*device_, quads_set_);
	return Nothing{};
}

Status ComposePass::writeResolveSet(const Targets& targets, const EdgeMask* mask)
{
	auto resolve_set = resolve_sets_.get(0);
	if (!resolve_set)
		return resolve_set.error();
	resolve_set_ = *resolve_set;
	gpu::DescriptorWriter writer;
	writer.uniformBuffer(0, params_.handle()).sampledImage(1, targets.sum.view(), sampler_.handle());
	if (mask)
		writer.sampledImage(2, mask->image().view(), sampler_.handle(), EdgeMask::kLayout);
	else
		writer.sampledImage(2, targets.lines.view(), sampler_.handle()); // one sample: weight 1
	writer.write(*device_, resolve_set_);
	return Nothing{};
}

void ComposePass::record(VkCommandBuffer commands, const Targets& targets, const glm::dvec2& jitter,
                         const VkRect2D& part, const EdgeMask* edges, bool first_part) const
{
	targets.sum.transition(commands, !edges && first_part ? gpu::kDiscard : gpu::kColorTarget, gpu::kColorTarget);
	recordInto(commands, targets, targets.sum.view(), jitter, part,
	           edges ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR, edges);
}

void ComposePass::recordWhole(VkCommandBuffer commands, const Targets& targets, const glm::dvec2& jitter) const
{
	recordInto(commands, targets, targets.picture.view(), jitter, {{0, 0}, targets.extent()},
	           VK_ATTACHMENT_LOAD_OP_DONT_CARE, nullptr);
}

void ComposePass::recordQuads(VkCommandBuffer commands, const EdgeQuads& quads, const glm::dvec2& jitter,
                              std::size_t sample, std::size_t samples) const
{
	const gpu::Pipeline& pipeline = pipelines_in_use_->quads;
	pipeline.bind(commands, quads_set_);
	shared::ComposePush push = all_sheets_;
	push.jitter[0] = static_cast<float>(jitter.x);
	push.jitter[1] = static_cast<float>(jitter.y);
	push.number = static_cast<std::uint32_t>(sample);
	push.last_number = static_cast<std::uint32_t>(samples - 1);
	pipeline.push(commands, push);
	vkCmdDispatchIndirect(commands, quads.listed().handle(), 0);
	EdgeQuads::recordBarrier(commands);
}

void ComposePass::recordInto(VkCommandBuffer commands, const Targets& targets, VkImageView view,
                             const glm::dvec2& jitter, const VkRect2D& part, VkAttachmentLoadOp load,
                             const EdgeMask* edges) const
{
	VkRenderingAttachmentInfo target{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	target.imageView = view;
	target.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
	target.loadOp = load;
	target.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	const VkRenderingAttachmentInfo mask = edges ? edges->asDepth() : VkRenderingAttachmentInfo{};
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea = part;
	rendering.layerCount = 1;
	rendering.colorAttachmentCount = 1;
	rendering.pColorAttachments = &target;
	rendering.pDepthAttachment = edges ? &mask : nullptr;
	vkCmdBeginRendering(commands, &rendering);
	const auto draw = [&](const VkRect2D& pixels, const Pipelines& pipelines, shared::ComposePush push)
	{
		const gpu::Pipeline& pipeline = edges ? pipelines.at_edges : pipelines.everywhere;
		coverPart(commands, targets.extent(), pixels);
		pipeline.bind(commands, set_);
		push.jitter[0] = static_cast<float>(jitter.x);
		push.jitter[1] = static_cast<float>(jitter.y);
		pipeline.push(commands, push);
		vkCmdDraw(commands, 3, 1, 0, 0);
	};
	if (regions_.empty())
		draw(part, *pipelines_in_use_, all_sheets_);
	for (const Region& region : regions_)
		draw(region.pixels, *region.pipelines, region.push);
	vkCmdEndRendering(commands);
}

void ComposePass::recordResolve(VkCommandBuffer commands, const Targets& targets, const VkRect2D& rows) const
{
	coverPart(commands, targets.part().picture, rows);
	resolve_.bind(commands, resolve_set_);
	resolve_.push(commands, shared::ResolvePush{static_cast<std::int32_t>(targets.part().first_row)});
	vkCmdDraw(commands, 3, 1, 0, 0);
}

} // namespace vp::render
