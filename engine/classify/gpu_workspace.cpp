#include "classify/gpu_workspace.h"

#include <algorithm>
#include <bit>

namespace vp::classify
{

namespace
{

// Replaces the buffer by one with at least `bytes`, and at least twice its size.
Status grow(gpu::Device& device, gpu::Buffer& buffer, std::size_t bytes, VkBufferUsageFlags usage, gpu::Memory memory,
            std::string_view name)
{
	// 16 KiB hold the fronts of a small cut; doubling from there takes few steps to any other.
	constexpr std::size_t kSmallest = 16384;
	if (buffer && buffer.size() >= bytes)
		return Nothing{};
	buffer = {};
	Result<gpu::Buffer> larger =
	    gpu::Buffer::create(device, std::bit_ceil(std::max(bytes, kSmallest)), usage, memory, name);
	if (!larger)
		return larger.error();
	buffer = std::move(*larger);
	return Nothing{};
}

} // namespace

Status ClassifyWorkspace::prepare(gpu::Device& device, const gpu::Pipeline& pipeline)
{
	if (commands.handle())
		return Nothing{};
	Result<gpu::Commands> made = gpu::Commands::create(device, "classify");
	if (!made)
		return made.error();
	commands = std::move(*made);
	sets = gpu::DescriptorSets(device, pipeline, "classify");
	return Nothing{};
}

Status ClassifyWorkspace::reserveFront(gpu::Device& device, std::size_t cells)
{
	if (Status grown = grow(device, front, 4 * cells, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::Memory::upload, "front");
	    !grown)
		return grown;
	return grow(device, codes, 4 * cells, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::Memory::readback, "codes");
}

Status ClassifyWorkspace::reserveSheets(gpu::Device& device, std::size_t bytes)
{
	return grow(device, sheets, bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, gpu::Memory::upload, "sheets");
}

Status ClassifyWorkspace::reserveAxes(gpu::Device& device, std::size_t texels)
{
	constexpr std::size_t kTexelBytes = 16;
	// Growing at most doubles it.
	if (texels > device.limits().maxTexelBufferElements / 4)
		return Error{ErrorKind::out_of_memory,
		             "more blocks and sheets than the device can address; use `classify` cpu"};
	if (axes && axes.size() >= texels * kTexelBytes)
		return Nothing{};
	axis_texels = {};
	if (Status grown = grow(device, axes, texels * kTexelBytes, VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
	                        gpu::Memory::upload, "axes");
	    !grown)
		return grown;
	Result<gpu::TexelView> view = gpu::TexelView::create(axes, VK_FORMAT_R32G32B32A32_UINT, "axes");
	if (!view)
		return view.error();
	axis_texels = std::move(*view);
	return Nothing{};
}

} // namespace vp::classify
