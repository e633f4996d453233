#include "gpu/vulkan.h"

#include "render/passes/surface_merge.h"

#include "gpu/commands.h"
#include "shared/render_types.h"

#include <algorithm>

namespace vp::render
{

namespace
{

struct NearestColor // as OpaqueTarget::kFormat
{
	std::uint32_t color;
	std::uint32_t surface;
};

Status makeHostRoom(gpu::Device& device, gpu::Buffer& buffer, std::uint64_t bytes)
{
	if (buffer && buffer.size() >= bytes)
		return Nothing{};
	auto made = gpu::Buffer::create(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                                gpu::Memory::readback, "surfaces to merge");
	if (!made)
		return made.error();
	buffer = std::move(*made);
	return Nothing{};
}

} // namespace

Status SurfaceMerge::makeBuffers(gpu::Device& device, const FragmentLists& lists)
{
	extent_ = lists.heads().extent();
	for (const auto& [buffer, bytes] :
	     {std::pair(&heads_, sizeof(std::uint32_t) * pixels()),
	      std::pair(&fragments_, sizeof(shared::SurfaceFragment) * lists.capacity()),
	      std::pair(&colors_, sizeof(NearestColor) * pixels()), std::pair(&depths_, sizeof(float) * pixels())})
		if (Status made = makeHostRoom(device, *buffer, bytes); !made)
			return made;
	return Nothing{};
}

Status SurfaceMerge::recordTaking(gpu::Device& device, VkCommandBuffer commands, const FragmentLists& lists,
                                  const SurfacePass& surfaces)
{
	if (Status made = makeBuffers(device, lists); !made)
		return made;
	// The sample before has read the buffers.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_NONE, VK_PIPELINE_STAGE_2_COPY_BIT,
	                   VK_ACCESS_2_TRANSFER_WRITE_BIT);
	lists.recordTaking(commands, heads_, fragments_);
	if (surfaces.hasOpaque())
		surfaces.opaque().recordTaking(commands, colors_, depths_);
	return Nothing{};
}

SurfaceFragments SurfaceMerge::taken(const SurfacePass& surfaces) const
{
	SurfaceFragments all;
	for (const gpu::Buffer* buffer : {&heads_, &fragments_, &colors_, &depths_})
		buffer->invalidate();
	const auto* heads = heads_.mappedAs<std::uint32_t>();
	const auto* fragments = fragments_.mappedAs<shared::SurfaceFragment>();
	const auto* colors = colors_.mappedAs<NearestColor>();
	const auto* depths = depths_.mappedAs<float>();
	for (std::uint32_t pixel = 0; pixel < pixels(); ++pixel)
	{
		for (std::uint32_t at = heads[pixel]; at != 0; at = fragments[at - 1].next)
		{
			const shared::SurfaceFragment& fragment = fragments[at - 1];
			all.listed.push_back({pixel, fragment.depth, fragment.color, fragment.order});
		}
		if (surfaces.hasOpaque() && depths[pixel] > 0.0f)
			all.nearest.push_back({pixel, depths[pixel], colors[pixel].color, colors[pixel].surface});
	}
	return all;
}

Status SurfaceMerge::recordPutting(gpu::Device& device, VkCommandBuffer commands, const SurfaceFragments& all,
                                   const FragmentLists& lists, const SurfacePass& surfaces)
{
	if (Status made = makeBuffers(device, lists); !made)
		return made;
	auto* heads = heads_.mappedAs<std::uint32_t>();
	auto* fragments = fragments_.mappedAs<shared::SurfaceFragment>();
	auto* colors = colors_.mappedAs<NearestColor>();
	auto* depths = depths_.mappedAs<float>();
	std::fill_n(heads, pixels(), 0u);
	std::fill_n(colors, pixels(), NearestColor{});
	std::fill_n(depths, pixels(), 0.0f);
	for (std::uint32_t i = 0; i < all.listed.size(); ++i)
	{
		const SurfacePixel& fragment = all.listed[i];
		fragments[i] = {heads[fragment.pixel], fragment.depth, fragment.color, fragment.order};
		heads[fragment.pixel] = i + 1;
	}
	for (const SurfacePixel& nearest : all.nearest)
	{
		colors[nearest.pixel] = {nearest.color, nearest.order};
		depths[nearest.pixel] = nearest.depth;
	}
	for (const gpu::Buffer* buffer : {&heads_, &fragments_, &colors_, &depths_})
		buffer->flush();
	lists.recordPutting(commands, heads_, fragments_, all.listed.size());
	if (surfaces.hasOpaque())
		surfaces.opaque().recordPutting(commands, colors_, depths_);
	return Nothing{};
}

} // namespace vp::render
