#include "gpu/vulkan.h"

#include "render/passes/layer_merge.h"

namespace vp::render
{

namespace
{

VkBufferImageCopy copyOf(const LayerValues& all)
{
	VkBufferImageCopy copy{};
	copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, all.layers};
	copy.imageExtent = {all.width, all.height, 1};
	return copy;
}

} // namespace

Result<VkCommandBuffer> LayerMerge::run(gpu::Device& device, gpu::Commands& commands, const Targets& targets,
                                        std::uint32_t layers, SurfaceFragments* surfaces, const MergeLayers& merge)
{
	LayerValues all{targets.extent().width,
	                targets.extent().height,
	                layers,
	                targets.values.format() == layerFormat(true) ? 2u : 1u,
	                {},
	                surfaces};
	if (layers > 0)
		if (Status taken = take(device, commands, targets, all); !taken)
			return taken.error();
	const bool goes_on = merge(all);
	Result<VkCommandBuffer> begun = commands.begin();
	if (!begun || !goes_on)
		return begun ? Result<VkCommandBuffer>(VkCommandBuffer(VK_NULL_HANDLE)) : begun;
	if (layers > 0)
	{
		values_.flush();
		const VkBufferImageCopy copy = copyOf(all);
		targets.values.transition(*begun, gpu::kSampled, gpu::kCopyTo);
		vkCmdCopyBufferToImage(*begun, values_.handle(), targets.values.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
		                       1, &copy);
		targets.values.transition(*begun, gpu::kCopyTo, gpu::kSampled);
	}
	return begun;
}

// Submits what has been recorded, and brings the layers to the host.
Status LayerMerge::take(gpu::Device& device, gpu::Commands& commands, const Targets& targets, LayerValues& all)
{
	if (!values_ || values_.size() < all.count() * sizeof(float))
	{
		auto made = gpu::Buffer::create(device, all.count() * sizeof(float),
		                                VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
		                                gpu::Memory::readback, "layers to merge");
		if (!made)
			return made.error();
		values_ = std::move(*made);
	}
	const VkBufferImageCopy copy = copyOf(all);
	// The sample before has read the buffer.
	gpu::memoryBarrier(commands.handle(), VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_NONE, VK_PIPELINE_STAGE_2_COPY_BIT,
	                   VK_ACCESS_2_TRANSFER_WRITE_BIT);
	targets.values.transition(commands.handle(), gpu::kSampled, gpu::kCopyFrom);
	vkCmdCopyImageToBuffer(commands.handle(), targets.values.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
	                       values_.handle(), 1, &copy);
	gpu::memoryBarrier(commands.handle(), VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
	targets.values.transition(commands.handle(), gpu::kCopyFrom, gpu::kSampled);
	if (Status done = commands.submitAndWait(); !done)
		return done;
	values_.invalidate();
	all.values = std::span(values_.mappedAs<float>(), all.count());
	return Nothing{};
}

} // namespace vp::render
