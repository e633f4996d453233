#include "gpu/memory.h"

#include "gpu/free_ranges.h"
#include "gpu/vk_check.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <new>
#include <utility>

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
	// The host-visible memory of a discrete device may be small, so it is left to uploads.
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

struct Arena::Page
{
	std::uint32_t type;
	VkDeviceMemory memory;
	std::byte* mapped; // null where the host cannot see it
	FreeRanges ranges;
};

Arena::Arena(VkDevice device, const Needs& needs)
    : device_(device), memory_(needs.memory),
      // Every piece is aligned to this, and its size is a multiple of it. So buffers and images may be neighbors, and a
      // flush by the host never touches another piece.
      granule_(std::max(needs.limits.bufferImageGranularity, needs.limits.nonCoherentAtomSize)),
      map_device_memory_(needs.map_device_memory)
{
}

Arena::~Arena()
{
	for (const auto& page : pages_)
		vkFreeMemory(device_, page->memory, nullptr);
}

Result<Arena::Piece> Arena::take(const VkMemoryRequirements& requirements, Memory kind)
{
	const MemoryPreference wish = wishFor(kind);
	const int type = chooseType(memory_, requirements.memoryTypeBits, wish, requirements.size);
	if (type < 0)
		return check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "no memory type is large enough").error();

	const std::lock_guard lock(mutex_);
	const auto taken = [&](int of)
	{
		const VkMemoryPropertyFlags flags = memory_.memoryTypes[of].propertyFlags;
		// Device memory is mapped only if direct writes need no flush.
		const bool map =
		    kind != Memory::device || (map_device_memory_ && (flags & VK_MEMORY_PROPERTY_HOST_COHERENT_BIT));
		return takeOfType(static_cast<std::uint32_t>(of), requirements.size, requirements.alignment, map);
	};
	Result<Piece> piece = taken(type);
	if (piece || kind != Memory::upload || piece.error().kind != ErrorKind::out_of_memory)
		return piece;
	// The device memory that the host can write may be full. Then host memory is used.
	MemoryPreference plain = wish;
	plain.avoided |= plain.preferred;
	plain.preferred = 0;
	const int other = chooseType(memory_, requirements.memoryTypeBits, plain, requirements.size);
	return other == type ? piece : taken(other);
}

Result<Arena::Piece> Arena::takeOfType(std::uint32_t type, VkDeviceSize size, VkDeviceSize alignment, bool map)
{
	alignment = std::max(alignment, granule_);
	size = (size + granule_ - 1) / granule_ * granule_;
	const auto pieceOf = [&](Page& page, VkDeviceSize offset)
	{
		Piece piece{page.memory, offset, size, nullptr, false, &page};
		piece.coherent = memory_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
		if (map && page.mapped)
			piece.mapped = page.mapped + offset;
		return piece;
	};
	for (const auto& page : pages_)
		if (page->type == type && page->ranges.free() >= size)
			if (const auto offset = page->ranges.take(size, alignment))
				return pieceOf(*page, *offset);

	// A large piece has its own page, which is freed with it.
	const VkDeviceSize shared = pageSize(type);
	Result<Page*> page = addPage(type, size > shared / 2 ? size : shared);
	if (!page && page.error().kind == ErrorKind::out_of_memory && size <= shared / 2)
		page = addPage(type, size); // what is left may be less than a page
	if (!page)
		return page.error();
	return pieceOf(**page, *(*page)->ranges.take(size, alignment));
}

Result<Arena::Page*> Arena::addPage(std::uint32_t type, VkDeviceSize size)
{
	// First, so that no memory of the device is lost for want of the host's.
	auto page = std::make_unique<Page>(Page{type, VK_NULL_HANDLE, nullptr, FreeRanges(size)});
	pages_.reserve(pages_.size() + 1);
	const VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, size, type};
	VkDeviceMemory memory = VK_NULL_HANDLE;
	if (Status allocated = check(vkAllocateMemory(device_, &info, nullptr, &memory), "vkAllocateMemory"); !allocated)
		return allocated.error();
	void* mapped = nullptr;
	if (memory_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
		if (Status done = check(vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory"); !done)
		{
			vkFreeMemory(device_, memory, nullptr);
			return done.error();
		}
	page->memory = memory;
	page->mapped = static_cast<std::byte*>(mapped);
	pages_.push_back(std::move(page));
	return pages_.back().get();
}

// A small page wastes little. A piece of half a page or more is its own allocation, and at most some two thousand of
// these fit into a heap.
VkDeviceSize Arena::pageSize(std::uint32_t type) const
{
	constexpr VkDeviceSize kLeast = VkDeviceSize(64) << 20;
	const VkDeviceSize heap = memory_.memoryHeaps[memory_.memoryTypes[type].heapIndex].size;
	return std::min(heap / 8, std::max(kLeast, heap / 1024));
}

void Arena::give(const Piece& piece)
{
	const std::lock_guard lock(mutex_);
	try
	{
		piece.page->ranges.give(piece.offset, piece.size);
	}
	catch (const std::bad_alloc&)
	{
		return; // a destructor calls this; the piece stays taken until the arena ends
	}
	if (!piece.page->ranges.allFree())
		return;
	// One empty page of each type is kept, since it is often needed again. Pages of a single large piece are not kept.
	const auto isSpare = [&](const auto& page)
	{ return page.get() != piece.page && page->type == piece.page->type && page->ranges.allFree(); };
	const bool is_shared = piece.page->ranges.bytes() == pageSize(piece.page->type);
	if (is_shared && std::none_of(pages_.begin(), pages_.end(), isSpare))
		return;
	vkFreeMemory(device_, piece.memory, nullptr);
	std::erase_if(pages_, [&](const auto& page) { return page.get() == piece.page; });
}

MemoryUse Arena::use() const
{
	const std::lock_guard lock(mutex_);
	MemoryUse use;
	use.pages = pages_.size();
	for (const auto& page : pages_)
	{
		use.reserved += page->ranges.bytes();
		use.used += page->ranges.bytes() - page->ranges.free();
	}
	return use;
}

VkDeviceSize Arena::freeIn(std::uint32_t heap) const
{
	const std::lock_guard lock(mutex_);
	VkDeviceSize free = 0;
	for (const auto& page : pages_)
		if (memory_.memoryTypes[page->type].heapIndex == heap)
			free += page->ranges.free();
	return free;
}

} // namespace vp::gpu
