#pragma once

#include "gpu/buffer.h"

#include <span>

namespace vp::gpu
{

// Fills a buffer by calling fill(destination, first, count) for runs of elements, in order: straight into its memory
// where that is mapped, else through a staging buffer of bounded size (the buffer then needs TRANSFER_DST usage). Done
// on return.
Status fillBuffer(Buffer& buffer, std::size_t elements, std::size_t element_bytes,
                  const std::function<void(std::byte* destination, std::size_t first, std::size_t count)>& fill);

Status upload(Buffer& buffer, std::span<const std::byte> bytes);

// A device-local buffer that holds `bytes`.
Result<Buffer> uploaded(Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage,
                        std::string_view name);

// The bytes of a buffer, through a readback buffer where it is not mapped (it then needs TRANSFER_SRC usage). For
// exports and tests.
Status download(const Buffer& buffer, VkDeviceSize offset, std::span<std::byte> bytes);

} // namespace vp::gpu
