#include "gpu/vulkan.h"

#include "render/passes/layer_pass.h"

#include "classify/gpu_records.h"
#include "gpu/commands.h"
#include "gpu/upload.h"
#include "render/passes/picture_geometry.h"
#include "shared/slice_types.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace vp::render
{

static_assert(sizeof(shared::LayerPush) == 80 && offsetof(shared::PolygonRecord, uv) == 8 &&
              offsetof(shared::PolygonRecord, value) == 56 && sizeof(shared::PolygonRecord) == 80);

namespace
{

constexpr gpu::ImageUse kSampledLayers{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                       VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
constexpr gpu::ImageUse kClearedLayers{VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_CLEAR_BIT,
                                       VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr gpu::ImageUse kComputedLayers{VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                        VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
// The stage of vkCmdUpdateBuffer is CLEAR, as it is one of the clear commands. Validation layers before 1.3.280 expect
// COPY.
constexpr VkPipelineStageFlags2 kUpdateStages = VK_PIPELINE_STAGE_2_CLEAR_BIT | VK_PIPELINE_STAGE_2_COPY_BIT;

std::uint32_t layerFeatures(const Scene& scene, const SheetDrawing& sheet)
{
	return (sheet.window ? shared::kLayerWindow : 0u) | (scene.look.mesh ? shared::kLayerMesh : 0u);
}

} // namespace

bool LayerPass::Drawn::operator==(const Drawn& other) const
{
	return record_count == other.record_count && features == other.features &&
	       (record_count == 0 || (records.lock() == other.records.lock() && !records.expired() &&
	                              std::memcmp(&push, &other.push, sizeof(push)) == 0));
}

Result<LayerPass> LayerPass::create(gpu::Device& device, std::uint32_t raster_side)
{
	LayerPass pass;
	pass.device_ = &device;
	auto raster = RasterPass::create(device);
	if (!raster)
		return raster.error();
	pass.raster_ = std::move(*raster);
	pass.raster_side_ = raster_side;
	auto first = pass.pipelineFor(0);
	if (!first)
		return first.error();
	pass.sets_ = gpu::DescriptorSets(device, **first, "layer");
	return pass;
}

Result<const gpu::Pipeline*> LayerPass::pipelineFor(std::uint32_t features)
{
	gpu::Pipeline& pipeline = pipelines_[features];
	if (pipeline)
		return &pipeline;
	gpu::GraphicsPipelineInfo info;
	info.vertex_shader = "render_layer.vert";
	info.fragment_shader = "render_layer.frag";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}, {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	info.push_bytes = sizeof(shared::LayerPush);
	info.color_formats = {layerFormat((features & shared::kLayerMesh) != 0)};
	info.constants = {{0, features}};
	auto made = gpu::Pipeline::create(*device_, info, "layer");
	if (!made)
		return made.error();
	pipeline = std::move(*made);
	return &pipeline;
}

bool LayerPass::computes(const Scene& scene, const SheetDrawing& sheet) const
{
	return raster_side_ > 0 && !scene.look.mesh && sheet.records && !sheet.records->overlapping;
}

Status LayerPass::prepare(const Scene& scene, const Targets& targets)
{
	page_sets_.clear();
	sheet_pipelines_.clear();
	computed_.clear();
	first_sets_.clear();
	for (const SheetDrawing& sheet : scene.sheets)
		computed_.push_back(computes(scene, sheet));
	if (Status ready = raster_.prepare(scene, targets, computed_); !ready)
		return ready;
	std::uint32_t largest = 0;
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		const SheetDrawing& sheet = scene.sheets[s];
		auto pipeline = pipelineFor(layerFeatures(scene, sheet) | (computed_[s] ? shared::kLayerListed : 0u));
		if (!pipeline)
			return pipeline.error();
		sheet_pipelines_.push_back(*pipeline);
		first_sets_.push_back(page_sets_.size());
		if (!sheet.records)
			continue;
		for (const auto& page : sheet.records->pages)
		{
			auto set = sets_.get(page_sets_.size());
			if (!set)
				return set.error();
			gpu::DescriptorWriter().texels(0, page.texels()).storageBuffer(1, raster_.list()).write(*device_, *set);
			page_sets_.push_back(*set);
			largest = std::max(largest, page.count);
		}
	}
	return makeIndices(largest);
}

Status LayerPass::makeIndices(std::uint32_t records)
{
	const VkDeviceSize bytes = sizeof(std::uint32_t) * shared::kRecordCorners * records;
	if (records == 0 || (indices_ && indices_.size() >= bytes))
		return Nothing{};
	std::vector<std::uint32_t> indices;
	indices.reserve(std::size_t(shared::kRecordCorners) * records);
	for (std::uint32_t record = 0; record < records; ++record)
		for (std::uint32_t triangle = 0; triangle < shared::kRecordTriangles; ++triangle)
			for (const std::uint32_t vertex : {0u, triangle + 1, triangle + 2})
				indices.push_back(shared::kMaxRecordVertices * record + vertex);
	auto made = gpu::uploaded(*device_, std::as_bytes(std::span(indices)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "fans");
	if (!made)
		return made.error();
	indices_ = std::move(*made);
	return Nothing{};
}

// What each layer is to be drawn from.
std::vector<LayerPass::Drawn> LayerPass::wanted(const Scene& scene, VkExtent2D extent, const glm::dvec2& jitter) const
{
	// Without sheets there is one layer, and it is empty.
	std::vector<Drawn> layers(std::max<std::size_t>(1, scene.sheets.size()));
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const SheetDrawing& sheet = scene.sheets[i];
		layers[i].records = sheet.records;
		layers[i].record_count = sheet.records ? sheet.records->count() : 0;
		layers[i].features = layerFeatures(scene, sheet);
		layers[i].push = layerPush(sheet, scene.camera, extent, jitter);
		layers[i].push.mesh_half_width = 0.5f * lineWidth(scene.look);
	}
	return layers;
}

std::size_t LayerPass::record(VkCommandBuffer commands, const Scene& scene, const Targets& targets,
                              const glm::dvec2& jitter)
{
	std::vector<Drawn> layers = wanted(scene, targets.extent(), jitter);
	std::vector<std::size_t> changed;
	std::vector<std::size_t> computed;
	for (std::size_t i = 0; i < layers.size(); ++i)
		if (i >= drawn_.size() || !(layers[i] == drawn_[i]))
		{
			changed.push_back(i);
			if (isComputed(i))
				computed.push_back(i);
		}
	if (changed.empty())
		return 0;
	const gpu::ImageUse before =
	    drawn_.empty() ? gpu::ImageUse{VK_IMAGE_LAYOUT_UNDEFINED, kSampledLayers.stages, kSampledLayers.access}
	                   : kSampledLayers;
	if (computed.empty())
		targets.values.transition(commands, before, gpu::kColorTarget);
	else
		recordComputed(commands, scene, targets, jitter, before, computed);
	for (const std::size_t i : changed)
		recordLayer(commands, scene, targets, i,
		            isComputed(i) ? listedPush(scene.sheets[i], scene.camera, targets.extent(), jitter)
		                          : layers[i].push);
	targets.values.transition(commands, gpu::kColorTarget, kSampledLayers);
	// Layers behind those of this scene keep what they hold.
	drawn_.resize(std::max(drawn_.size(), layers.size()));
	std::move(layers.begin(), layers.end(), drawn_.begin());
	return changed.size();
}

// Small polygons of those layers; leaves all layers ready to be drawn into.
void LayerPass::recordComputed(VkCommandBuffer commands, const Scene& scene, const Targets& targets,
                               const glm::dvec2& jitter, const gpu::ImageUse& before,
                               std::span<const std::size_t> layers) const
{
	// The sample before has read its lists.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT,
	                   VK_ACCESS_2_NONE, kUpdateStages | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE);
	targets.values.transition(commands, before, kClearedLayers);
	raster_.recordStart(commands);
	const VkClearColorValue empty{{shared::kEmptyValue, 0.0f, 0.0f, 0.0f}};
	for (const std::size_t i : layers)
	{
		const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, static_cast<std::uint32_t>(i), 1};
		vkCmdClearColorImage(commands, targets.values.handle(), VK_IMAGE_LAYOUT_GENERAL, &empty, 1, &range);
	}
	gpu::memoryBarrier(commands, kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
	                   VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
	targets.values.transition(commands, kClearedLayers, kComputedLayers);
	for (const std::size_t i : layers)
		raster_.record(commands, scene, i, targets.extent(), jitter, raster_side_);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT,
	                   VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
	targets.values.transition(commands, kComputedLayers, gpu::kColorTarget);
}

void LayerPass::drawPages(VkCommandBuffer commands, const classify::SheetRecords& records, std::size_t i,
                          const shared::LayerPush& push) const
{
	for (std::size_t p = 0; p < records.pages.size(); ++p)
	{
		sheet_pipelines_[i]->bind(commands, page_sets_[first_sets_[i] + p]);
		sheet_pipelines_[i]->push(commands, push);
		vkCmdDrawIndexed(commands, records.pages[p].count * shared::kRecordCorners, 1, 0, 0, 0);
	}
}

void LayerPass::drawListed(VkCommandBuffer commands, std::size_t i, shared::LayerPush push) const
{
	for (const RasterPass::Run& run : raster_.runs(i))
	{
		push.listed_from = run.listed_from;
		sheet_pipelines_[i]->bind(commands, page_sets_[first_sets_[i] + run.page]);
		sheet_pipelines_[i]->push(commands, push);
		vkCmdDrawIndexedIndirect(commands, raster_.draws(), sizeof(shared::RasterDraw) * run.draw, 1, 0);
	}
}

// A layer's polygons, or those of them that the compute shader left.
void LayerPass::recordLayer(VkCommandBuffer commands, const Scene& scene, const Targets& targets, std::size_t i,
                            shared::LayerPush push) const
{
	const bool computed = isComputed(i);
	VkRenderingAttachmentInfo layer{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	layer.imageView = targets.layer(i);
	layer.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
	layer.loadOp = computed ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
	layer.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	layer.clearValue.color.float32[0] = shared::kEmptyValue;
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea.extent = targets.extent();
	rendering.layerCount = 1;
	rendering.colorAttachmentCount = 1;
	rendering.pColorAttachments = &layer;
	vkCmdBeginRendering(commands, &rendering);
	if (i < scene.sheets.size() && scene.sheets[i].records)
	{
		coverAll(commands, targets.extent());
		if (indices_)
			vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
		if (computed)
			drawListed(commands, i, push);
		else
			drawPages(commands, *scene.sheets[i].records, i, push);
	}
	vkCmdEndRendering(commands);
}

} // namespace vp::render
