#include "gpu/vulkan.h"

#include "render/passes/edge_mask.h"

#include "gpu/commands.h"
#include "render/passes/buffers.h"
#include "shared/render_types.h"

#include <algorithm>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::EdgePush) == 12);

constexpr VkPipelineStageFlags2 kTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr gpu::ImageUse kRead{EdgeMask::kLayout, kTests | gpu::kSampled.stages,
                              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | gpu::kSampled.access};

} // namespace

Result<EdgeMask> EdgeMask::create(gpu::Device& device)
{
	EdgeMask mask;
	mask.device_ = &device;
	gpu::GraphicsPipelineInfo find;
	find.vertex_shader = "render_full.vert";
	find.fragment_shader = "render_edges.frag";
	find.bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
	find.depth_format = kDepthFormat;
	find.depth_test = true;
	find.depth_write = true;
	find.depth_compare = VK_COMPARE_OP_ALWAYS;
	auto found = gpu::Pipeline::create(device, find, "edges");
	if (!found)
		return found.error();
	mask.find_ = std::move(*found);
	mask.find_sets_ = gpu::DescriptorSets(device, mask.find_, "edges");
	gpu::ComputePipelineInfo list;
	list.shader = "render_edge_tiles.comp";
	list.bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	list.push_bytes = sizeof(shared::EdgePush);
	auto listed = gpu::Pipeline::create(device, list, "edge tiles");
	if (!listed)
		return listed.error();
	mask.list_ = std::move(*listed);
	mask.list_sets_ = gpu::DescriptorSets(device, mask.list_, "edge tiles");
	auto sampler = gpu::Sampler::create(device, VK_FILTER_NEAREST, "edges");
	if (!sampler)
		return sampler.error();
	mask.sampler_ = std::move(*sampler);
	return mask;
}

Status EdgeMask::prepare(const Targets& targets, std::uint32_t reach)
{
	const VkExtent2D extent = targets.extent();
	reach_ = reach;
	if (!image_ || image_.extent().width != extent.width || image_.extent().height != extent.height)
	{
		image_ = {}; // before its successor, that both need not fit into memory
		gpu::ImageInfo info;
		info.extent = extent;
		info.format = kDepthFormat;
		info.usage =
		    VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
		auto made = gpu::Image::create(*device_, info, "edges");
		if (!made)
			return made.error();
		image_ = std::move(*made);
	}
	const VkDeviceSize tiles = VkDeviceSize(edgeTilesOver(extent.width)) * edgeTilesOver(extent.height);
	const bool had_room = tiles_ && tiles_.size() >= sizeof(std::uint32_t) * tiles;
	if (Status made = makeRoom(*device_, tiles_, sizeof(std::uint32_t) * tiles,
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
	                           "edge tiles", gpu::Memory::device);
	    !made)
		return made;
	if (!had_room)
	{
		const VkDeviceSize texel_bytes = sizeof(std::uint32_t) * VkDeviceSize(device_->limits().maxTexelBufferElements);
		auto texels =
		    gpu::TexelView::create(tiles_, VK_FORMAT_R32_UINT, "edge tiles", 0, std::min(tiles_.size(), texel_bytes));
		if (!texels)
			return texels.error();
		tile_texels_ = std::move(*texels);
	}
	if (Status made = makeRoom(*device_, listed_, sizeof(shared::RasterList) + sizeof(std::uint32_t) * tiles,
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
	                               VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                           "listed edge tiles", gpu::Memory::device);
	    !made)
		return made;
	auto find_set = find_sets_.get(0);
	if (!find_set)
		return find_set.error();
	find_set_ = *find_set;
	gpu::DescriptorWriter().sampledImage(0, targets.sum.view(), sampler_.handle()).write(*device_, find_set_);
	auto list_set = list_sets_.get(0);
	if (!list_set)
		return list_set.error();
	list_set_ = *list_set;
	gpu::DescriptorWriter()
	    .sampledImage(0, image_.view(), sampler_.handle(), kLayout)
	    .storageBuffer(1, tiles_.handle())
	    .storageBuffer(2, listed_.handle())
	    .write(*device_, list_set_);
	return Nothing{};
}

void EdgeMask::record(VkCommandBuffer commands, const Targets& targets) const
{
	const VkExtent2D extent = image_.extent();
	targets.sum.transition(commands, gpu::kColorTarget, gpu::kSampled);
	image_.transition(commands, gpu::kDiscard, gpu::kDepthTarget);
	VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	depth.imageView = image_.view();
	depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
	depth.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
	depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea.extent = extent;
	rendering.layerCount = 1;
	rendering.pDepthAttachment = &depth;
	vkCmdBeginRendering(commands, &rendering);
	coverAll(commands, extent);
	find_.bind(commands, find_set_);
	vkCmdDraw(commands, 3, 1, 0, 0);
	vkCmdEndRendering(commands);
	targets.sum.transition(commands, gpu::kSampled, gpu::kColorTarget);
	image_.transition(commands, gpu::kDepthTarget, kRead);

	constexpr VkPipelineStageFlags2 kUsers =
	    VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
	constexpr VkAccessFlags2 kUses = VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT |
	                                 VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
	gpu::memoryBarrier(commands, kUsers, VK_ACCESS_2_NONE, gpu::kUpdateStages, VK_ACCESS_2_NONE);
	const shared::RasterList none{{0, 1, 1}, 0};
	vkCmdUpdateBuffer(commands, listed_.handle(), 0, sizeof(none), &none);
	gpu::memoryBarrier(commands, gpu::kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT, kUsers, kUses);
	const shared::EdgePush push = edgePush();
	const std::uint32_t tiles = push.tiles_across * push.tiles_down;
	list_.bind(commands, list_set_);
	list_.push(commands, push);
	vkCmdDispatch(commands, (tiles + shared::kEdgeGroupSize - 1) / shared::kEdgeGroupSize, 1, 1);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kUsers,
	                   kUses);
}

shared::EdgePush EdgeMask::edgePush() const
{
	return {edgeTilesOver(image_.extent().width), edgeTilesOver(image_.extent().height), reach_};
}

VkRenderingAttachmentInfo EdgeMask::asDepth() const
{
	VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	depth.imageView = image_.view();
	depth.imageLayout = kLayout;
	depth.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
	depth.storeOp = VK_ATTACHMENT_STORE_OP_NONE;
	return depth;
}

void EdgeMask::recordCopy(VkCommandBuffer commands, const gpu::Image& to) const
{
	image_.transition(commands, kRead, gpu::kCopyFrom);
	VkImageCopy copy{};
	copy.srcSubresource = copy.dstSubresource = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 0, 1};
	copy.extent = {image_.extent().width, image_.extent().height, 1};
	vkCmdCopyImage(commands, image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.handle(),
	               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
	image_.transition(commands, gpu::kCopyFrom, kRead);
}

} // namespace vp::render
