#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"

#include <cstdint>

namespace vp::render
{

// All of a picture's surface fragments at once, at the most: 16 bytes each. More are drawn strip by strip.
constexpr std::uint64_t kMaxFragmentBytes = std::uint64_t(512) << 20;

// The surface fragments of each pixel as a linked list, in device memory: a head a pixel and room for so many
// fragments. They are counted while they are drawn, also those for which there was no room: then complete() makes more,
// or, where there is none to be had, parts the picture into strips of rows that are drawn one after the other in the
// same room; and the picture is drawn again. Nothing is allocated before prepare().
class FragmentLists
{
public:
	FragmentLists(gpu::Device& device, std::uint64_t most_bytes) : device_(&device), most_bytes_(most_bytes) {}

	// Takes no more bytes than these from now on.
	void limit(std::uint64_t most_bytes) { most_bytes_ = most_bytes; }

	// For pictures of this size, of so many samples. While no submission draws.
	Status prepare(VkExtent2D extent, std::size_t samples);

	std::uint32_t strips() const { return strips_; }
	VkRect2D strip(std::uint32_t i) const;
	std::uint32_t counter(std::size_t sample, std::uint32_t strip) const
	{
		return static_cast<std::uint32_t>(sample) * strips_ + strip;
	}
	std::uint32_t capacity() const { return capacity_; } // fragments

	void recordStart(VkCommandBuffer commands) const;  // at the start of a picture
	void recordSample(VkCommandBuffer commands) const; // empties the lists
	// Between drawing a strip's surfaces and composing it, and before the next strip's.
	void recordBarrier(VkCommandBuffer commands) const;
	void recordEnd(VkCommandBuffer commands) const; // at the end of a picture

	// Call it after the picture. Returns true if every fragment had room. If not, call prepare() and draw the picture
	// again. It is an error if a single row of pixels has more fragments than fit.
	Result<bool> complete();

	// Makes room for this number of fragments. Returns true if the buffers are new. It is an error if there is no room.
	Result<bool> makeRoom(std::uint64_t fragments);
	// Returns the number of fragments of a finished sample of a picture in one strip. Call it after complete().
	std::uint32_t count(std::size_t sample) const { return counts_.mappedAs<std::uint32_t>()[sample]; }

	// Copies all lists to a host's buffers, behind what has been drawn, and back again.
	void recordTaking(VkCommandBuffer commands, const gpu::Buffer& heads, const gpu::Buffer& fragments) const;
	void recordPutting(VkCommandBuffer commands, const gpu::Buffer& heads, const gpu::Buffer& fragments,
	                   std::uint64_t count) const;

	const gpu::Image& heads() const { return heads_; }
	const gpu::Buffer& fragments() const { return fragments_; }
	VkBufferView fragmentTexels() const { return fragment_texels_.handle(); } // one each
	const gpu::Buffer& counters() const { return counters_; }

private:
	std::uint64_t mostFragments() const;
	Status grow(std::uint64_t fragments);

	gpu::Device* device_;
	std::uint64_t most_bytes_;
	std::uint32_t strips_ = 1;
	std::uint32_t capacity_ = 0;
	std::size_t counted_ = 0; // counters in use
	gpu::Image heads_;
	gpu::Buffer fragments_;
	gpu::TexelView fragment_texels_;
	gpu::Buffer counters_; // fragments of each sample and strip
	gpu::Buffer counts_;   // the same for the host
};

} // namespace vp::render
