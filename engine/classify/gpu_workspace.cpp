#include "classify/gpu_workspace.h"

#include <algorithm>
#include <bit>

namespace vp::classify
{

namespace
{

// 16 KiB hold the fronts of a small cut; doubling from there takes few steps to any other.
std::size_t grownSize(std::size_t bytes)
{
	constexpr std::size_t kSmallest = 16384;
	return std::bit_ceil(std::max(bytes, kSmallest));
}

// Replaces the buffer by one with at least `bytes`, and at least twice its size.
Status grow(gpu::Device& device, gpu::Buffer& buffer, std::size_t bytes, VkBufferUsageFlags usage, gpu::Memory memory,
            std::string_view name)
{
	if (buffer && buffer.size() >= bytes)
		return Nothing{};
	buffer = {};
	Result<gpu::Buffer> larger = gpu::Buffer::create(device, grownSize(bytes), usage, memory, name);
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
	if (texels > gpu::ShaderArray::maxElements(device) / 4)
		return Error{ErrorKind::out_of_memory,
		             "more blocks and sheets than the device can address; use `classify` cpu"};
	if (axes && axes.buffer().size() >= texels * kTexelBytes)
		return Nothing{};
	axes = {};
	Result<gpu::ShaderArray> larger = gpu::ShaderArray::create(
	    device, grownSize(texels * kTexelBytes), VK_FORMAT_R32G32B32A32_UINT, gpu::Memory::upload, "axes");
	if (!larger)
		return larger.error();
	axes = std::move(*larger);
	return Nothing{};
}

} // namespace vp::classify
