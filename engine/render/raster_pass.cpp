#include "gpu/vulkan.h"

#include "render/raster_pass.h"

#include "gpu/commands.h"
#include "render/picture_geometry.h"
#include "slice/gpu_records.h"

#include <algorithm>
#include <cassert>

namespace vp::render
{

static_assert(sizeof(shared::RasterPush) == 116 && sizeof(shared::RasterDraw) == sizeof(VkDrawIndexedIndirectCommand));

namespace
{

// vkCmdUpdateBuffer takes so many bytes.
constexpr std::size_t kMostUpdate = 65536 / sizeof(shared::RasterDraw);

Status makeDeviceRoom(gpu::Device& device, gpu::Buffer& buffer, VkDeviceSize bytes, VkBufferUsageFlags usage,
                      const char* name)
{
	if (buffer && buffer.size() >= bytes)
		return Nothing{};
	auto made =
	    gpu::Buffer::create(device, std::max<VkDeviceSize>(bytes + bytes / 2, 1024), usage, gpu::Memory::device, name);
	if (!made)
		return made.error();
	buffer = std::move(*made);
	return Nothing{};
}

} // namespace

Result<RasterPass> RasterPass::create(gpu::Device& device)
{
	RasterPass pass;
	pass.device_ = &device;
	auto first = pass.pipelineFor(0);
	if (!first)
		return first.error();
	pass.sets_ = gpu::DescriptorSets(device, **first, "raster");
	return pass;
}

Result<const gpu::Pipeline*> RasterPass::pipelineFor(std::uint32_t features)
{
	gpu::Pipeline& pipeline = pipelines_[features];
	if (pipeline)
		return &pipeline;
	gpu::ComputePipelineInfo info;
	info.shader = "render_raster.comp";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
	                 {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	info.push_bytes = sizeof(shared::RasterPush);
	info.constants = {{0, features}};
	auto made = gpu::Pipeline::create(*device_, info, "raster");
	if (!made)
		return made.error();
	pipeline = std::move(*made);
	return &pipeline;
}

Status RasterPass::prepare(const Scene& scene, const Targets& targets, const std::vector<bool>& computed)
{
	pages_.clear();
	first_pages_.clear();
	sheet_pipelines_.clear();
	std::uint32_t records = 0;
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		first_pages_.push_back(pages_.size());
		sheet_pipelines_.push_back(nullptr);
		if (!computed[s])
			continue;
		auto pipeline = pipelineFor(scene.sheets[s].window ? shared::kLayerWindow : 0u);
		if (!pipeline)
			return pipeline.error();
		sheet_pipelines_.back() = *pipeline;
		for (const auto& page : scene.sheets[s].records->pages)
		{
			auto set = sets_.get(pages_.size());
			if (!set)
				return set.error();
			pages_.push_back({records, *set});
			records += page.count;
		}
	}
	assert(pages_.size() <= kMostUpdate); // of 5 MiB each
	if (Status room = makeDeviceRoom(*device_, list_, sizeof(std::uint32_t) * records,
	                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "large polygons");
	    !room)
		return room;
	if (Status room = makeDeviceRoom(*device_, draws_, sizeof(shared::RasterDraw) * pages_.size(),
	                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
	                                     VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                                 "draws of large polygons");
	    !room)
		return room;
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
		for (std::size_t p = 0; sheet_pipelines_[s] && p < scene.sheets[s].records->pages.size(); ++p)
			gpu::DescriptorWriter()
			    .texels(0, scene.sheets[s].records->pages[p].texels())
			    .storageImage(1, targets.layer(s))
			    .storageBuffer(2, list_.handle())
			    .storageBuffer(3, draws_.handle())
			    .write(*device_, pages_[first_pages_[s] + p].set);
	return Nothing{};
}

void RasterPass::recordStart(VkCommandBuffer commands) const
{
	if (pages_.empty())
		return;
	const std::vector<shared::RasterDraw> none(pages_.size(), {0, 1, 0, 0, 0});
	vkCmdUpdateBuffer(commands, draws_.handle(), 0, sizeof(none[0]) * none.size(), none.data());
}

void RasterPass::record(VkCommandBuffer commands, const Scene& scene, std::size_t sheet, VkExtent2D extent,
                        const glm::dvec2& jitter, std::uint32_t side) const
{
	const SheetDrawing& drawing = scene.sheets[sheet];
	shared::RasterPush push = rasterPush(drawing, scene.camera, extent, jitter);
	push.largest = static_cast<float>(std::min(side, shared::kMostRasterSide) * shared::kSubpixels);
	const gpu::Pipeline& pipeline = *sheet_pipelines_[sheet];
	std::size_t page = first_pages_[sheet];
	for (const auto& records : drawing.records->pages)
	{
		push.count = records.count;
		push.draw = static_cast<std::uint32_t>(page);
		push.listed_from = pages_[page].listed_from;
		pipeline.bind(commands, pages_[page].set);
		pipeline.push(commands, push);
		vkCmdDispatch(commands, (records.count + shared::kRasterGroupSize - 1) / shared::kRasterGroupSize, 1, 1);
		++page;
	}
}

} // namespace vp::render
