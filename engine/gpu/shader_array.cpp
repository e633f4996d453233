#include "gpu/shader_array.h"

namespace vp::gpu
{

namespace
{

// Devices whose texel buffers hold fewer elements keep large grids in storage buffers. Vulkan promises 65 536 elements;
// most devices for desktops take 2^27 or more.
constexpr std::uint32_t kEnoughTexels = 1u << 26;

// A shader has so many storage buffers besides, and so many arrays; Vulkan promises four in all.
constexpr std::uint32_t kStorageBuffers = 3 + 5;

} // namespace

bool ShaderArray::usesStorage(const Device& device)
{
	return device.limits().maxTexelBufferElements < kEnoughTexels &&
	       device.limits().maxPerStageDescriptorStorageBuffers >= kStorageBuffers;
}

VkDescriptorType ShaderArray::descriptorType(const Device& device)
{
	return usesStorage(device) ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
}

std::uint64_t ShaderArray::maxElements(const Device& device)
{
	return usesStorage(device) ? device.limits().maxStorageBufferRange / 16 : device.limits().maxTexelBufferElements;
}

Result<ShaderArray> ShaderArray::create(Device& device, VkDeviceSize size, VkFormat format, Memory memory,
                                        std::string_view name, VkBufferUsageFlags more_usage)
{
	const bool storage = usesStorage(device);
	const VkBufferUsageFlags usage =
	    storage ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
	Result<Buffer> buffer = Buffer::create(device, size, usage | more_usage, memory, name);
	if (!buffer)
		return buffer.error();
	ShaderArray array;
	array.buffer_ = std::move(*buffer);
	if (storage)
		return array;
	Result<TexelView> view = TexelView::create(array.buffer_, format, name);
	if (!view)
		return view.error();
	array.texels_ = std::move(*view);
	return array;
}

} // namespace vp::gpu
