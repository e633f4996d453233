#include "gpu/memory.h"

#include "gpu/vk_check.h"

#include <bit>

namespace vp::gpu
{

namespace
{
struct MemoryPreference
{
	VkMemoryPropertyFlags required;
	VkMemoryPropertyFlags preferred;
	VkMemoryPropertyFlags avoided;
};

MemoryPreference wishFor(Memory kind)
{
	switch (kind)
	{
	case Memory::upload:
		return {VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
		        VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
	case Memory::readback:
		return {VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT,
		        VK_MEMORY_PROPERTY_HOST_CACHED_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
		        VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
	case Memory::device:
		break;
	}
	// A discrete device's window of host-visible memory may be small: leave it to uploads.
	return {0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT};
}

// The type with the most preferred and then the fewest avoided properties; the driver lists faster ones first.
int chooseType(const VkPhysicalDeviceMemoryProperties& memory, std::uint32_t allowed, const MemoryPreference& wish,
               VkDeviceSize size)
{
	int best = -1;
	int best_score = -1;
	for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
	{
		const VkMemoryPropertyFlags flags = memory.memoryTypes[i].propertyFlags;
		const VkMemoryPropertyFlags unusable =
		    VK_MEMORY_PROPERTY_PROTECTED_BIT | VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT |
		    VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD | VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD;
		if (!(allowed >> i & 1u) || (flags & wish.required) != wish.required || (flags & unusable))
			continue;
		if (size > memory.memoryHeaps[memory.memoryTypes[i].heapIndex].size)
			continue;
		const int score = 8 * std::popcount(flags & wish.preferred) + 4 - std::popcount(flags & wish.avoided);
		if (score > best_score)
		{
			best = static_cast<int>(i);
			best_score = score;
		}
	}
	return best;
}
} // namespace

Result<Allocation> allocate(Device& device, const VkMemoryRequirements& requirements, Memory kind,
                            std::string_view name)
{
	const VkPhysicalDeviceMemoryProperties& memory = device.memory();
	const int type = chooseType(memory, requirements.memoryTypeBits, wishFor(kind), requirements.size);
	if (type < 0)
		return check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "no memory type is large enough").error();

	VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, requirements.size,
	                          static_cast<std::uint32_t>(type)};
	Allocation made;
	VkResult result = vkAllocateMemory(device.handle(), &info, nullptr, &made.memory);
	if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY && kind == Memory::upload)
	{
		// The device-local window for the host may be full; memory of the host will do.
		MemoryPreference plain = wishFor(kind);
		plain.avoided |= plain.preferred;
		plain.preferred = 0;
		if (const int other = chooseType(memory, requirements.memoryTypeBits, plain, requirements.size); other != type)
		{
			info.memoryTypeIndex = static_cast<std::uint32_t>(other);
			result = vkAllocateMemory(device.handle(), &info, nullptr, &made.memory);
		}
	}
	if (Status allocated = check(result, "vkAllocateMemory"); !allocated)
		return allocated.error();
	device.setName(VK_OBJECT_TYPE_DEVICE_MEMORY, made.memory, name);

	const VkMemoryPropertyFlags flags = memory.memoryTypes[info.memoryTypeIndex].propertyFlags;
	made.coherent = flags & VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
	// Device memory is mapped only where writing it directly needs no flush.
	const bool map = kind != Memory::device ||
	                 (device.mapsDeviceMemory() && (flags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) && made.coherent);
	if (map)
		if (Status mapped =
		        check(vkMapMemory(device.handle(), made.memory, 0, VK_WHOLE_SIZE, 0, &made.mapped), "vkMapMemory");
		    !mapped)
		{
			vkFreeMemory(device.handle(), made.memory, nullptr);
			return mapped.error();
		}
	return made;
}

} // namespace vp::gpu
