#include "gpu/buffer.h"

#include "gpu/vk_check.h"
#include "gpu/workarounds.h"

namespace vp::gpu
{

Result<Buffer> Buffer::create(Device& device, VkDeviceSize size, VkBufferUsageFlags usage, Memory memory,
                              std::string_view name)
{
	if (size > device.maxBufferSize())
		return check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "a buffer past the device's limit").error();
	VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
	info.size = allocatedSize(size, usage);
	info.usage = usage;
	Buffer buffer;
	if (Status made = check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer.handle_), "vkCreateBuffer"); !made)
		return made.error();
	buffer.device_ = &device;
	buffer.size_ = info.size;
	buffer.usage_ = usage;
	device.setName(VK_OBJECT_TYPE_BUFFER, buffer.handle_, name);

	VkMemoryRequirements requirements;
	vkGetBufferMemoryRequirements(device.handle(), buffer.handle_, &requirements);
	Result<Arena::Piece> piece = device.arena().take(requirements, memory);
	if (!piece)
		return piece.error();
	buffer.piece_ = *piece;
	if (Status bound = check(vkBindBufferMemory(device.handle(), buffer.handle_, piece->memory, piece->offset),
	                         "vkBindBufferMemory");
	    !bound)
		return bound.error();
	return buffer;
}

Buffer::~Buffer()
{
	if (handle_)
		device_->retire(
		    [handle = handle_, piece = piece_, &arena = device_->arena()](VkDevice device)
		    {
			    vkDestroyBuffer(device, handle, nullptr);
			    if (piece.page)
				    arena.give(piece);
		    });
}

void Buffer::flush() const
{
	if (piece_.coherent)
		return;
	const VkMappedMemoryRange range = piece_.range();
	require(vkFlushMappedMemoryRanges(device_->handle(), 1, &range), "vkFlushMappedMemoryRanges");
}

void Buffer::invalidate() const
{
	if (piece_.coherent)
		return;
	const VkMappedMemoryRange range = piece_.range();
	require(vkInvalidateMappedMemoryRanges(device_->handle(), 1, &range), "vkInvalidateMappedMemoryRanges");
}

void Buffer::swap(Buffer& other) noexcept
{
	std::swap(device_, other.device_);
	std::swap(handle_, other.handle_);
	std::swap(piece_, other.piece_);
	std::swap(size_, other.size_);
	std::swap(usage_, other.usage_);
}

Result<TexelView> TexelView::create(const Buffer& buffer, VkFormat format, std::string_view name, VkDeviceSize offset,
                                    VkDeviceSize size)
{
	VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
	info.buffer = buffer.handle();
	info.format = format;
	info.offset = offset;
	info.range = size ? size : buffer.size() - offset;
	TexelView view;
	if (Status made =
	        check(vkCreateBufferView(buffer.device().handle(), &info, nullptr, &view.handle_), "vkCreateBufferView");
	    !made)
		return made.error();
	view.device_ = &buffer.device();
	buffer.device().setName(VK_OBJECT_TYPE_BUFFER_VIEW, view.handle_, name);
	return view;
}

TexelView::~TexelView()
{
	if (handle_)
		device_->retire([handle = handle_](VkDevice device) { vkDestroyBufferView(device, handle, nullptr); });
}

} // namespace vp::gpu
