#include "gpu/vulkan.h"

#include "render/passes/overlay_pass.h"

#include "render/passes/buffers.h"
#include "shared/render_types.h"

#include <cstddef>
#include <cstring>

namespace vp::render
{

Result<OverlayPass> OverlayPass::create(gpu::Device& device)
{
	gpu::GraphicsPipelineInfo info;
	info.vertex_shader = "render_overlay.vert";
	info.fragment_shader = "render_overlay.frag";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
	info.push_bytes = sizeof(shared::OverlayPush);
	info.vertex_bindings = {{0, sizeof(ImDrawVert), VK_VERTEX_INPUT_RATE_VERTEX}};
	info.vertex_attributes = {{0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
	                          {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
	                          {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)}};
	info.color_formats = {kPictureFormat};
	info.blends = {gpu::premultipliedOver()};
	auto pipeline = gpu::Pipeline::create(device, info, "overlay");
	if (!pipeline)
		return pipeline.error();
	auto sampler = gpu::Sampler::create(device, VK_FILTER_LINEAR, "letters");
	if (!sampler)
		return sampler.error();
	OverlayPass pass;
	pass.device_ = &device;
	pass.pipeline_ = std::move(*pipeline);
	pass.sampler_ = std::move(*sampler);
	pass.sets_ = gpu::DescriptorSets(device, pass.pipeline_, "overlay");
	return pass;
}

Status OverlayPass::prepare(const Overlay& overlay)
{
	count_ = static_cast<std::uint32_t>(overlay.indices.size());
	if (count_ == 0)
		return Nothing{};
	const auto put = [this](gpu::Buffer& buffer, const auto& values, VkBufferUsageFlags usage,
	                        const char* name) -> Status
	{
		const std::size_t bytes = values.size() * sizeof(values[0]);
		if (Status room = makeRoom(*device_, buffer, bytes, usage, name); !room)
			return room;
		std::memcpy(buffer.mapped(), values.data(), bytes);
		buffer.flush();
		return Nothing{};
	};
	if (Status put_in = put(vertices_, overlay.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "overlay vertices");
	    !put_in)
		return put_in;
	if (Status put_in = put(indices_, overlay.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "overlay indices"); !put_in)
		return put_in;

	if (Status uploaded = putLetters(overlay.lettering); !uploaded)
		return uploaded;
	auto set = sets_.get(0);
	if (!set)
		return set.error();
	set_ = *set;
	gpu::DescriptorWriter().sampledImage(0, letters_.view(), sampler_.handle()).write(*device_, set_);
	return Nothing{};
}

Status OverlayPass::putLetters(const std::shared_ptr<const FontAtlas>& lettering)
{
	if (lettering == lettering_)
		return Nothing{};
	const glm::ivec2 size = lettering->texelSize();
	gpu::ImageInfo info;
	info.extent = {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
	info.format = VK_FORMAT_R8_UNORM;
	info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
	auto letters = gpu::Image::create(*device_, info, "letters");
	if (!letters)
		return letters.error();
	letters_ = std::move(*letters);
	const auto texels = std::as_bytes(std::span(lettering->texels(), std::size_t(size.x) * size.y));
	lettering_ = nullptr;
	if (Status uploaded = gpu::uploadImage(*device_, letters_, texels, gpu::kSampled); !uploaded)
		return uploaded;
	lettering_ = lettering;
	return Nothing{};
}

void OverlayPass::record(VkCommandBuffer commands, const Targets& targets) const
{
	if (count_ == 0)
		return;
	const VkExtent2D extent = targets.part().picture;
	coverAll(commands, extent);
	pipeline_.bind(commands, set_);
	pipeline_.push(commands, shared::OverlayPush{
	                             {2.0f / static_cast<float>(extent.width), 2.0f / static_cast<float>(extent.height)}});
	const VkBuffer vertices = vertices_.handle();
	const VkDeviceSize offset = 0;
	vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
	vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
	vkCmdDrawIndexed(commands, count_, 1, 0, 0, 0);
}

} // namespace vp::render
