#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace vp::gpu
{

enum class Memory
{
	device,  // as fast as it gets for the GPU; mapped only where that costs nothing (software and integrated devices)
	upload,  // written by the host, read by the GPU: coherent, device-local where there is such a thing
	readback // written by the GPU, read by the host: cached; invalidate() before reading
};

/// How much memory of a device is taken.
struct MemoryUse
{
	std::size_t pages = 0;     // allocations of the driver
	VkDeviceSize reserved = 0; // bytes of the pages
	VkDeviceSize used = 0;     // bytes of the pieces in them
};

/// The memory of a device. It is taken from the driver in pages, which have one memory type each, and handed out in
/// pieces. A driver allows only limits().maxMemoryAllocationCount allocations (4096 is common), and a data set of some
/// thousand blocks needs more buffers than that. Thread safe.
class Arena
{
	struct Page;

public:
	/// Memory for one buffer or image.
	struct Piece
	{
		VkDeviceMemory memory = VK_NULL_HANDLE;
		VkDeviceSize offset = 0;
		VkDeviceSize size = 0;
		void* mapped = nullptr; // the piece's first byte; null where the memory is not mapped
		bool coherent = false;
		Page* page = nullptr;

		VkMappedMemoryRange range() const
		{
			return {VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE, nullptr, memory, offset, size};
		}
	};

	struct Needs
	{
		const VkPhysicalDeviceMemoryProperties& memory;
		const VkPhysicalDeviceLimits& limits;
		bool map_device_memory; // Memory::device is mapped where that costs nothing
	};

	Arena(VkDevice device, const Needs& needs);
	~Arena(); // the device is idle, and all pieces were given back
	Arena(const Arena&) = delete;
	Arena& operator=(const Arena&) = delete;

	Result<Piece> take(const VkMemoryRequirements& requirements, Memory kind);
	void give(const Piece& piece);

	MemoryUse use() const;
	VkDeviceSize freeIn(std::uint32_t heap) const; // bytes of its pages that no piece has

private:
	Result<Piece> takeOfType(std::uint32_t type, VkDeviceSize size, VkDeviceSize alignment, bool map);
	Result<Page*> addPage(std::uint32_t type, VkDeviceSize size);
	VkDeviceSize pageSize(std::uint32_t type) const;

	VkDevice device_;
	VkPhysicalDeviceMemoryProperties memory_;
	VkDeviceSize granule_;
	bool map_device_memory_;
	mutable std::mutex mutex_; // the pages
	std::vector<std::unique_ptr<Page>> pages_;
};

} // namespace vp::gpu
