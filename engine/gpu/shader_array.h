#pragma once

#include "gpu/buffer.h"

namespace vp::gpu
{

// An array that shaders read (shaders/arrays.glsl). It is a texel buffer, which software reads faster, or a storage
// buffer where the device's texel buffers are small. Move-only, as Buffer.
class ShaderArray
{
public:
	// The array as a descriptor names it. Null: no array.
	struct Place
	{
		VkBufferView texels = VK_NULL_HANDLE; // null: a storage buffer
		VkBuffer buffer = VK_NULL_HANDLE;

		explicit operator bool() const { return buffer != VK_NULL_HANDLE; }
	};

	// Returns true if arrays are storage buffers on this device.
	static bool usesStorage(const Device& device);
	static VkDescriptorType descriptorType(const Device& device);
	static std::uint64_t maxElements(const Device& device); // largest number of 16-byte elements of one array

	ShaderArray() = default;
	// format: of an element, if it is a texel. More usage than that of a shader's array may be given.
	static Result<ShaderArray> create(Device& device, VkDeviceSize size, VkFormat format, Memory memory,
	                                  std::string_view name, VkBufferUsageFlags more_usage = 0);

	explicit operator bool() const { return static_cast<bool>(buffer_); }
	const Buffer& buffer() const { return buffer_; }
	Buffer& buffer() { return buffer_; }
	Place place() const { return {texels_.handle(), buffer_.handle()}; }

private:
	Buffer buffer_;
	TexelView texels_; // none on a device that uses storage
};

} // namespace vp::gpu
