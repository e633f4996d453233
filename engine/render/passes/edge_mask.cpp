#include "gpu/vulkan.h"

#include "render/passes/edge_mask.h"

#include "shared/render_types.h"

namespace vp::render
{

namespace
{

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
	if (Status ready = tiles_.prepare(*device_, extent, reach); !ready)
		return ready;
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
	    .storageBuffer(1, tiles_.tiles().handle())
	    .storageBuffer(2, tiles_.listed().handle())
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

	tiles_.recordEmpty(commands);
	list_.bind(commands, list_set_);
	list_.push(commands, tiles_.push());
	vkCmdDispatch(commands, (tiles_.count() + shared::kEdgeGroupSize - 1) / shared::kEdgeGroupSize, 1, 1);
	EdgeTiles::recordListed(commands);
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
