#include "gpu/vulkan.h"

#include "render/passes/surface_culling.h"

#include "gpu/commands.h"
#include "render/passes/buffers.h"
#include "render/passes/picture_geometry.h"
#include "render/passes/surface_polygons.h"

#include <algorithm>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::IndexedDraw) == sizeof(VkDrawIndexedIndirectCommand) &&
              sizeof(shared::SurfaceCullPush) <= 128);

constexpr std::uint32_t kMinTriangles = 2000; // to draw fewer costs no more than to look for them
constexpr std::uint64_t kMaxTriangles = std::uint64_t(1) << 26;

constexpr VkPipelineStageFlags2 kCullStage = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kDrawStages =
    VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT;

} // namespace

Status SurfaceCulling::makePipelines()
{
	if (list_)
		return Nothing{};
	gpu::ComputePipelineInfo cull;
	cull.shader = "render_surface_cull.comp";
	cull.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {1, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {3, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
	                 {4, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	cull.push_bytes = sizeof(shared::SurfaceCullPush);
	auto culls = gpu::Pipeline::create(*device_, cull, "surface triangles at edges");
	if (!culls)
		return culls.error();
	gpu::ComputePipelineInfo list;
	list.shader = "render_surface_kept.comp";
	list.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	list.push_bytes = sizeof(shared::SurfaceCullPush);
	auto lists = gpu::Pipeline::create(*device_, list, "listed surface triangles");
	if (!lists)
		return lists.error();
	auto sampler = gpu::Sampler::create(*device_, VK_FILTER_NEAREST, "surface triangles at edges");
	if (!sampler)
		return sampler.error();
	cull_ = std::move(*culls);
	list_ = std::move(*lists);
	sampler_ = std::move(*sampler);
	cull_sets_ = gpu::DescriptorSets(*device_, cull_, "surface triangles at edges");
	list_sets_ = gpu::DescriptorSets(*device_, list_, "listed surface triangles");
	return Nothing{};
}

Status SurfaceCulling::makeBuffers(std::uint32_t words, std::uint32_t triangles)
{
	words_ = words;
	const VkDeviceSize bytes = sizeof(std::uint32_t) * VkDeviceSize(words);
	const bool had_room = kept_ && kept_.size() >= bytes;
	if (Status room = makeRoom(*device_, kept_, bytes,
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
	                               VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                           "surface triangles at edges", gpu::Memory::device);
	    !room)
		return room;
	if (!had_room)
	{
		const VkDeviceSize most = sizeof(std::uint32_t) * VkDeviceSize(device_->limits().maxTexelBufferElements);
		auto texels = gpu::TexelView::create(kept_, VK_FORMAT_R32_UINT, "surface triangles at edges", 0,
		                                     std::min(kept_.size(), most));
		if (!texels)
			return texels.error();
		kept_texels_ = std::move(*texels);
	}
	if (Status room = makeRoom(*device_, indices_, sizeof(std::uint32_t) * 3 * VkDeviceSize(triangles),
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
	                           "listed surface triangles", gpu::Memory::device);
	    !room)
		return room;
	return makeRoom(*device_, draws_, sizeof(shared::IndexedDraw) * runs_.size(),
	                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, "surface draws",
	                gpu::Memory::device);
}

Status SurfaceCulling::writeSets(const Scene& scene, const EdgeMask& mask, const OpaqueTarget& opaque)
{
	for (std::size_t r = 0; r < runs_.size(); ++r)
	{
		auto set = cull_sets_.get(r);
		if (!set)
			return set.error();
		runs_[r].set = *set;
		const SurfacePolygons::Part& part = scene.surfaces[runs_[r].surface].polygons->parts[runs_[r].part];
		gpu::DescriptorWriter()
		    .texels(0, part.triangle_texels.handle())
		    .texels(1, part.vertex_texels.handle())
		    .sampledImage(2, mask.image().view(), sampler_.handle(), EdgeMask::kLayout)
		    .sampledImage(3, opaque.depth().view(), sampler_.handle(), OpaqueTarget::kDepthLayout)
		    .storageBuffer(4, kept_.handle())
		    .write(*device_, *set);
	}
	auto list = list_sets_.get(0);
	if (!list)
		return list.error();
	list_set_ = *list;
	gpu::DescriptorWriter()
	    .texels(0, kept_texels_.handle())
	    .storageBuffer(1, indices_.handle())
	    .storageBuffer(2, draws_.handle())
	    .write(*device_, list_set_);
	return Nothing{};
}

Status SurfaceCulling::prepare(const Scene& scene, std::span<const std::size_t> surfaces, const EdgeMask* mask,
                               const OpaqueTarget& opaque)
{
	runs_.clear();
	if (!mask || !device_->isSoftware())
		return Nothing{};
	std::uint64_t words = 0;
	std::uint64_t triangles = 0;
	for (const std::size_t s : surfaces)
	{
		if (!scene.surfaces[s].polygons)
			continue;
		const auto& parts = scene.surfaces[s].polygons->parts;
		for (std::size_t p = 0; p < parts.size(); ++p)
		{
			runs_.push_back(
			    {s, p, parts[p].count, static_cast<std::uint32_t>(words), static_cast<std::uint32_t>(3 * triangles)});
			words += (parts[p].count + 31) / 32;
			triangles += parts[p].count;
		}
	}
	const std::uint64_t most = std::min<std::uint64_t>(kMaxTriangles, device_->limits().maxStorageBufferRange / 12);
	if (triangles < kMinTriangles || triangles > most || words > device_->limits().maxTexelBufferElements)
	{
		runs_.clear();
		return Nothing{};
	}
	Status ready = makePipelines();
	if (ready)
		ready = makeBuffers(static_cast<std::uint32_t>(words), static_cast<std::uint32_t>(triangles));
	return ready ? writeSets(scene, *mask, opaque) : ready;
}

void SurfaceCulling::record(VkCommandBuffer commands, const Scene& scene, const PicturePart& part) const
{
	gpu::memoryBarrier(commands, kCullStage | kDrawStages, VK_ACCESS_2_NONE, gpu::kUpdateStages, VK_ACCESS_2_NONE);
	vkCmdFillBuffer(commands, kept_.handle(), 0, sizeof(std::uint32_t) * VkDeviceSize(words_), 0);
	gpu::memoryBarrier(commands, gpu::kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCullStage,
	                   VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
	std::vector<shared::SurfaceCullPush> pushes;
	for (std::size_t r = 0; r < runs_.size(); ++r)
	{
		const Run& run = runs_[r];
		shared::SurfaceCullPush& push = pushes.emplace_back();
		const glm::dmat4 clip =
		    clipMatrix(scene.camera, part, scene.surfaces[run.surface].polygons->origin, glm::dvec2(0.0));
		for (int k = 0; k < 16; ++k)
			push.clip[k] = static_cast<float>(clip[k / 4][k % 4]);
		push.near_w = static_cast<float>(scene.camera.near);
		push.width = static_cast<float>(part.extent.width);
		push.height = static_cast<float>(part.extent.height);
		push.count = run.count;
		push.first_word = run.first_word;
		push.first_index = run.first_index;
		push.draw = static_cast<std::uint32_t>(r);
		cull_.bind(commands, run.set);
		cull_.push(commands, push);
		vkCmdDispatch(commands, (run.count + shared::kCullGroupSize - 1) / shared::kCullGroupSize, 1, 1);
	}
	gpu::memoryBarrier(commands, kCullStage, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kCullStage,
	                   VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
	for (const shared::SurfaceCullPush& push : pushes)
	{
		list_.bind(commands, list_set_);
		list_.push(commands, push);
		vkCmdDispatch(commands, 1, 1, 1);
	}
	gpu::memoryBarrier(commands, kCullStage, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kDrawStages,
	                   VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT);
}

void SurfaceCulling::recordDraw(VkCommandBuffer commands, std::size_t surface, std::size_t part) const
{
	const auto run =
	    std::ranges::find_if(runs_, [&](const Run& each) { return each.surface == surface && each.part == part; });
	vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
	vkCmdDrawIndexedIndirect(commands, draws_.handle(),
	                         sizeof(shared::IndexedDraw) * static_cast<VkDeviceSize>(run - runs_.begin()), 1,
	                         sizeof(shared::IndexedDraw));
}

} // namespace vp::render
