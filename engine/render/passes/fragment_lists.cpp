#include "gpu/vulkan.h"

#include "render/passes/fragment_lists.h"

#include "gpu/commands.h"
#include "shared/render_types.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::SurfaceFragment) == 16);

// A closed surface all over the picture.
constexpr std::uint64_t kFirstPerPixel = 2;

// A buffer of texels may become a little longer than it was asked for (gpu/workarounds.h).
constexpr std::uint64_t kLonger = 64;

void fragmentBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 before, VkAccessFlags2 access)
{
	gpu::memoryBarrier(commands, before, access, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
	                   VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
	                       VK_ACCESS_2_SHADER_SAMPLED_READ_BIT);
}

} // namespace

std::uint64_t FragmentLists::mostFragments() const
{
	const std::uint64_t bytes =
	    std::min<std::uint64_t>({most_bytes_, device_->limits().maxStorageBufferRange, device_->maxBufferSize()});
	return std::clamp<std::uint64_t>(bytes / sizeof(shared::SurfaceFragment), 1,
	                                 device_->limits().maxTexelBufferElements - kLonger);
}

Status FragmentLists::grow(std::uint64_t fragments)
{
	fragment_texels_ = {};
	fragments_ = {}; // before its successor, that both need not fit into memory
	capacity_ = 0;
	auto made = gpu::Buffer::create(*device_, fragments * sizeof(shared::SurfaceFragment),
	                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
	                                    VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                                gpu::Memory::device, "surface fragments");
	if (!made)
		return made.error();
	auto texels = gpu::TexelView::create(*made, VK_FORMAT_R32G32B32A32_UINT, "surface fragments");
	if (!texels)
		return texels.error();
	fragments_ = std::move(*made);
	fragment_texels_ = std::move(*texels);
	capacity_ = static_cast<std::uint32_t>(fragments);
	return Nothing{};
}

Status FragmentLists::prepare(VkExtent2D extent, std::size_t samples)
{
	if (!heads_ || heads_.extent().width != extent.width || heads_.extent().height != extent.height)
	{
		heads_ = {};
		strips_ = 1;
		gpu::ImageInfo info;
		info.extent = extent;
		info.format = VK_FORMAT_R32_UINT;
		info.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
		auto made = gpu::Image::create(*device_, info, "surface lists");
		if (!made)
			return made.error();
		heads_ = std::move(*made);
	}
	if (!fragments_)
	{
		const std::uint64_t first = kFirstPerPixel * extent.width * extent.height;
		if (Status grown = grow(std::min(first, mostFragments())); !grown)
			return grown;
	}
	counted_ = samples * strips_;
	const VkDeviceSize bytes = sizeof(std::uint32_t) * counted_;
	if (counters_ && counters_.size() >= bytes)
		return Nothing{};
	auto counters = gpu::Buffer::create(*device_, bytes,
	                                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
	                                        VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
	                                    gpu::Memory::device, "surface counters");
	if (!counters)
		return counters.error();
	auto counts =
	    gpu::Buffer::create(*device_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::readback, "surface counts");
	if (!counts)
		return counts.error();
	counters_ = std::move(*counters);
	counts_ = std::move(*counts);
	return Nothing{};
}

VkRect2D FragmentLists::strip(std::uint32_t i) const
{
	const VkExtent2D extent = heads_.extent();
	const auto row = [&](std::uint32_t s)
	{ return static_cast<std::uint32_t>(std::uint64_t(extent.height) * s / strips_); };
	return {{0, static_cast<std::int32_t>(row(i))}, {extent.width, row(i + 1) - row(i)}};
}

void FragmentLists::recordStart(VkCommandBuffer commands) const
{
	// The picture before may have left them at any of these.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
	                   VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
	vkCmdFillBuffer(commands, counters_.handle(), 0, sizeof(std::uint32_t) * counted_, 0);
	fragmentBarrier(commands, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
}

void FragmentLists::recordSample(VkCommandBuffer commands) const
{
	heads_.transition(commands, gpu::kDiscard, gpu::kCopyTo);
	const VkClearColorValue none{};
	const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
	vkCmdClearColorImage(commands, heads_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &none, 1, &all);
	heads_.transition(commands, gpu::kCopyTo, gpu::kStorage);
}

void FragmentLists::recordBarrier(VkCommandBuffer commands) const
{
	fragmentBarrier(commands, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
	                VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void FragmentLists::recordEnd(VkCommandBuffer commands) const
{
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
	                   VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT);
	const VkBufferCopy all{0, 0, sizeof(std::uint32_t) * counted_};
	vkCmdCopyBuffer(commands, counters_.handle(), counts_.handle(), 1, &all);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

Result<bool> FragmentLists::makeRoom(std::uint64_t fragments)
{
	if (fragments <= capacity_)
		return false;
	if (fragments > mostFragments())
		return Error{ErrorKind::out_of_memory,
		             fmt::format("the picture has {} surface fragments, more than the {} the device has room for; make "
		                         "`size` smaller, or use vprobe",
		                         fragments, mostFragments())};
	if (Status grown = grow(fragments); !grown)
		return grown.error();
	return true;
}

namespace
{

VkBufferImageCopy allOf(const gpu::Image& image)
{
	VkBufferImageCopy copy{};
	copy.imageSubresource = {image.aspect(), 0, 0, 1};
	copy.imageExtent = {image.extent().width, image.extent().height, 1};
	return copy;
}

} // namespace

void FragmentLists::recordTaking(VkCommandBuffer commands, const gpu::Buffer& heads, const gpu::Buffer& fragments) const
{
	const VkBufferImageCopy copy = allOf(heads_);
	heads_.transition(commands, gpu::kStorage, gpu::kCopyFrom);
	vkCmdCopyImageToBuffer(commands, heads_.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, heads.handle(), 1, &copy);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
	const VkBufferCopy all{0, 0, sizeof(shared::SurfaceFragment) * capacity_};
	vkCmdCopyBuffer(commands, fragments_.handle(), fragments.handle(), 1, &all);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

void FragmentLists::recordPutting(VkCommandBuffer commands, const gpu::Buffer& heads, const gpu::Buffer& fragments,
                                  std::uint64_t count) const
{
	const VkBufferImageCopy copy = allOf(heads_);
	heads_.transition(commands, gpu::kDiscard, gpu::kCopyTo);
	vkCmdCopyBufferToImage(commands, heads.handle(), heads_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
	heads_.transition(commands, gpu::kCopyTo, gpu::kStorage);
	if (count == 0)
		return;
	const VkBufferCopy some{0, 0, sizeof(shared::SurfaceFragment) * count};
	vkCmdCopyBuffer(commands, fragments.handle(), fragments_.handle(), 1, &some);
	fragmentBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
}

Result<bool> FragmentLists::complete()
{
	counts_.invalidate();
	const auto* counts = counts_.mappedAs<std::uint32_t>();
	const std::uint64_t needed = *std::max_element(counts, counts + counted_);
	if (needed <= capacity_)
		return true;
	// A quarter more, for the next picture of a film.
	const std::uint64_t wanted = std::min(needed + needed / 4, mostFragments());
	if (wanted > capacity_)
	{
		const std::uint64_t before = capacity_;
		if (Status grown = grow(wanted); !grown)
			if (Status back = grow(before); !back)
				return back.error();
	}
	if (needed <= capacity_)
		return false;
	const std::uint32_t rows = heads_.extent().height;
	if (strips_ >= rows)
	{
		strips_ = 1; // for another picture
		return Error{ErrorKind::out_of_memory,
		             fmt::format("a row of the picture has {} surface fragments, more than the {} the device "
		                         "has room for; make `size` smaller, or leave `context` out",
		                         needed, capacity_)};
	}
	// Surfaces crowd in some strips: a fifth more than the mean asks for.
	strips_ =
	    static_cast<std::uint32_t>(std::min<std::uint64_t>(rows, strips_ * (needed + needed / 5) / capacity_ + 1));
	return false;
}

} // namespace vp::render
