#pragma once

#include "gpu/device.h"
#include "gpu/memory.h"

#include <cstddef>
#include <utility>

namespace vp::gpu
{

// A buffer and its memory. Move-only; the destructor waits for nothing (see Device).
class Buffer
{
public:
	Buffer() = default;
	static Result<Buffer> create(Device& device, VkDeviceSize size, VkBufferUsageFlags usage, Memory memory,
	                             std::string_view name);
	~Buffer();
	Buffer(Buffer&& other) noexcept { swap(other); }
	Buffer& operator=(Buffer&& other) noexcept
	{
		Buffer taken(std::move(other));
		swap(taken);
		return *this;
	}

	explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
	VkBuffer handle() const { return handle_; }
	VkDeviceSize size() const { return size_; } // what was asked for, or a little more
	VkBufferUsageFlags usage() const { return usage_; }
	Device& device() const { return *device_; }

	// Null where the memory is not mapped; upload and readback memory always is.
	void* mapped() const { return piece_.mapped; }
	template <class T>
	T* mappedAs() const
	{
		return static_cast<T*>(piece_.mapped);
	}
	void flush() const;      // makes host writes visible to the GPU; does nothing for coherent memory
	void invalidate() const; // makes GPU writes visible to the host, after the wait; does nothing for coherent memory

private:
	void swap(Buffer& other) noexcept;

	Device* device_ = nullptr;
	VkBuffer handle_ = VK_NULL_HANDLE;
	Arena::Piece piece_;
	VkDeviceSize size_ = 0;
	VkBufferUsageFlags usage_ = 0;
};

// A buffer seen as an array of texels (the buffer's usage must say so); read with texelFetch in shaders.
class TexelView
{
public:
	TexelView() = default;
	// `size` of 0 takes the rest of the buffer. At most limits().maxTexelBufferElements texels.
	static Result<TexelView> create(const Buffer& buffer, VkFormat format, std::string_view name,
	                                VkDeviceSize offset = 0, VkDeviceSize size = 0);
	~TexelView();
	TexelView(TexelView&& other) noexcept { swap(other); }
	TexelView& operator=(TexelView&& other) noexcept
	{
		TexelView taken(std::move(other));
		swap(taken);
		return *this;
	}

	explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
	VkBufferView handle() const { return handle_; }

private:
	void swap(TexelView& other) noexcept
	{
		std::swap(device_, other.device_);
		std::swap(handle_, other.handle_);
	}

	Device* device_ = nullptr;
	VkBufferView handle_ = VK_NULL_HANDLE;
};

} // namespace vp::gpu
