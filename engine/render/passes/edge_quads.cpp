#include "gpu/vulkan.h"

#include "render/passes/edge_quads.h"

#include "gpu/commands.h"

#include <algorithm>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::QuadList) == sizeof(VkDispatchIndirectCommand) + sizeof(std::uint32_t) &&
              shared::kEdgeGroupSize % (shared::kEdgeTile / 2) == 0);

constexpr VkDeviceSize kSumBytes = 8;        // bytes of a pixel's sum
constexpr std::uint32_t kMaxSide = 1u << 17; // a quad's place is two times 16 bits

constexpr VkPipelineStageFlags2 kQuadStage = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kQuadUsers = VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | kQuadStage;
constexpr VkAccessFlags2 kSumUses = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;

VkDeviceSize quadsOf(VkExtent2D extent)
{
	return VkDeviceSize((extent.width + 1) / 2) * ((extent.height + 1) / 2);
}

} // namespace

bool EdgeQuads::fits(const gpu::Device& device, VkExtent2D extent)
{
	return std::max(extent.width, extent.height) <= kMaxSide &&
	       4 * kSumBytes * quadsOf(extent) <= device.limits().maxStorageBufferRange;
}

Result<EdgeQuads> EdgeQuads::create(gpu::Device& device)
{
	EdgeQuads quads;
	quads.device_ = &device;
	gpu::ComputePipelineInfo info;
	info.shader = "render_edge_quads.comp";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	info.push_bytes = sizeof(shared::EdgePush);
	auto find = gpu::Pipeline::create(device, info, "edge quads");
	if (!find)
		return find.error();
	quads.find_ = std::move(*find);
	quads.sets_ = gpu::DescriptorSets(device, quads.find_, "edge quads");
	auto sampler = gpu::Sampler::create(device, VK_FILTER_NEAREST, "edge quads");
	if (!sampler)
		return sampler.error();
	quads.sampler_ = std::move(*sampler);
	return quads;
}

Status EdgeQuads::prepare(const Targets& targets, std::uint32_t reach)
{
	const VkExtent2D extent = targets.extent();
	if (Status ready = tiles_.prepare(*device_, extent, reach); !ready)
		return ready;
	if (!sums_ || extent_.width != extent.width || extent_.height != extent.height)
	{
		release(); // before their successors, that both need not fit into memory
		const VkDeviceSize quads = quadsOf(extent);
		auto listed = gpu::Buffer::create(*device_, sizeof(shared::QuadList) + sizeof(std::uint32_t) * quads,
		                                  VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
		                                      VK_BUFFER_USAGE_TRANSFER_DST_BIT,
		                                  gpu::Memory::device, "listed edge quads");
		if (!listed)
			return listed.error();
		auto sums = gpu::Buffer::create(*device_, 4 * kSumBytes * quads, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
		                                gpu::Memory::device, "sums at edges");
		if (!sums)
			return sums.error();
		listed_ = std::move(*listed);
		sums_ = std::move(*sums);
		extent_ = extent;
	}
	auto set = sets_.get(0);
	if (!set)
		return set.error();
	set_ = *set;
	gpu::DescriptorWriter()
	    .sampledImage(0, targets.picture.view(), sampler_.handle())
	    .storageBuffer(1, tiles_.tiles().handle())
	    .storageBuffer(2, tiles_.listed().handle())
	    .storageBuffer(3, listed_.handle())
	    .write(*device_, set_);
	return Nothing{};
}

void EdgeQuads::release()
{
	listed_ = {};
	sums_ = {};
}

void EdgeQuads::record(VkCommandBuffer commands, const Targets& targets) const
{
	targets.picture.transition(commands, gpu::kColorTarget, gpu::kSampled);
	gpu::memoryBarrier(commands, kQuadUsers, VK_ACCESS_2_NONE, gpu::kUpdateStages, VK_ACCESS_2_NONE);
	const shared::QuadList none{{0, 1, 1}, 0};
	vkCmdUpdateBuffer(commands, listed_.handle(), 0, sizeof(none), &none);
	gpu::memoryBarrier(commands, gpu::kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT, kQuadStage, kSumUses);
	tiles_.recordEmpty(commands);
	const shared::EdgePush& push = tiles_.push();
	constexpr std::uint32_t columns = shared::kEdgeTile / 2;
	find_.bind(commands, set_);
	find_.push(commands, push);
	vkCmdDispatch(commands, (columns * push.tiles_across + shared::kEdgeGroupSize - 1) / shared::kEdgeGroupSize,
	              push.tiles_down, 1);
	EdgeTiles::recordListed(commands);
	targets.picture.transition(commands, gpu::kSampled, gpu::kStorage);
}

void EdgeQuads::recordBarrier(VkCommandBuffer commands)
{
	gpu::memoryBarrier(commands, kQuadStage, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kQuadStage, kSumUses);
}

} // namespace vp::render
