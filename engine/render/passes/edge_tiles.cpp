#include "gpu/vulkan.h"

#include "render/passes/edge_tiles.h"

#include "gpu/commands.h"
#include "render/passes/buffers.h"

#include <algorithm>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::EdgePush) == 12 &&
              sizeof(shared::TileList) == sizeof(VkDispatchIndirectCommand) + sizeof(VkDrawIndirectCommand));

constexpr VkPipelineStageFlags2 kTileUsers = VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT |
                                             VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                             VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkAccessFlags2 kTileUses = VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT |
                                     VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;

} // namespace

Status EdgeTiles::prepare(gpu::Device& device, VkExtent2D extent, std::uint32_t reach)
{
	push_ = {edgeTilesOver(extent.width), edgeTilesOver(extent.height), reach};
	const VkDeviceSize bytes = sizeof(std::uint32_t) * VkDeviceSize(count());
	const bool had_room = tiles_ && tiles_.size() >= bytes;
	if (Status made = makeRoom(device, tiles_, bytes,
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
	                               VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                           "edge tiles", gpu::Memory::device);
	    !made)
		return made;
	if (!had_room)
	{
		const VkDeviceSize most = sizeof(std::uint32_t) * VkDeviceSize(device.limits().maxTexelBufferElements);
		auto texels =
		    gpu::TexelView::create(tiles_, VK_FORMAT_R32_UINT, "edge tiles", 0, std::min(tiles_.size(), most));
		if (!texels)
			return texels.error();
		texels_ = std::move(*texels);
	}
	return makeRoom(device, listed_, sizeof(shared::TileList) + bytes,
	                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
	                    VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                "listed edge tiles", gpu::Memory::device);
}

void EdgeTiles::recordEmpty(VkCommandBuffer commands) const
{
	gpu::memoryBarrier(commands, kTileUsers, VK_ACCESS_2_NONE, gpu::kUpdateStages, VK_ACCESS_2_NONE);
	vkCmdFillBuffer(commands, tiles_.handle(), 0, sizeof(std::uint32_t) * VkDeviceSize(count()), 0);
	const shared::TileList none{{0, 1, 1}, 0, 1, {0, 0}};
	vkCmdUpdateBuffer(commands, listed_.handle(), 0, sizeof(none), &none);
	gpu::memoryBarrier(commands, gpu::kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT, kTileUsers, kTileUses);
}

void EdgeTiles::recordListed(VkCommandBuffer commands)
{
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   kTileUsers, kTileUses);
}

} // namespace vp::render
