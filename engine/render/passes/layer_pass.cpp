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
#include <utility>

namespace vp::render
{

static_assert(sizeof(shared::LayerPush) == 68 && offsetof(shared::PolygonRecord, uv) == 8 &&
              offsetof(shared::PolygonRecord, value) == 56 && sizeof(shared::PolygonRecord) == 80);

namespace
{

constexpr gpu::ImageUse kSampledLayers{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                       VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                       VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
constexpr gpu::ImageUse kClearedLayers{VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_CLEAR_BIT,
                                       VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr gpu::ImageUse kComputedLayers{VK_IMAGE_LAYOUT_GENERAL, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                        VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};

std::uint32_t layerFeatures(const Scene& scene, const SheetDrawing& sheet)
{
	return (sheet.window ? shared::kLayerWindow : 0u) | (scene.look.mesh ? shared::kLayerMesh : 0u);
}

} // namespace

bool LayerPass::Drawn::operator==(const Drawn& other) const
{
	return !only_edges && !other.only_edges && record_count == other.record_count && features == other.features &&
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
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}};
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

Status LayerPass::prepare(const Scene& scene, const Targets& targets, const EdgeTiles* edges)
{
	knows_edges_ = false;
	page_sets_.clear();
	sheet_pipelines_.clear();
	computed_.clear();
	first_sets_.clear();
	for (const SheetDrawing& sheet : scene.sheets)
		computed_.push_back(computes(scene, sheet));
	if (Status ready = raster_.prepare(scene, targets, computed_, edges); !ready)
		return ready;
	std::uint32_t largest = 0;
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		const SheetDrawing& sheet = scene.sheets[s];
		sheet_pipelines_.push_back(nullptr);
		first_sets_.push_back(page_sets_.size());
		if (!sheet.records || computed_[s])
			continue;
		auto pipeline = pipelineFor(layerFeatures(scene, sheet));
		if (!pipeline)
			return pipeline.error();
		sheet_pipelines_.back() = *pipeline;
		for (const auto& page : sheet.records->pages)
		{
			auto set = sets_.get(page_sets_.size());
			if (!set)
				return set.error();
			gpu::DescriptorWriter().texels(0, page.texels()).write(*device_, *set);
			page_sets_.push_back(*set);
			largest = std::max(largest, page.count);
		}
	}
	layer_clear_sets_.assign(scene.sheets.size(), VK_NULL_HANDLE);
	if (edges)
		if (Status made = makeClearSets(scene.sheets.size(), targets, *edges); !made)
			return made;
	return makeIndices(largest);
}

Status LayerPass::makeClearSets(std::size_t layers, const Targets& targets, const EdgeTiles& edges)
{
	if (!clear_)
	{
		gpu::ComputePipelineInfo info;
		info.shader = "render_clear_tiles.comp";
		info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}, {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
		info.push_bytes = sizeof(shared::EdgePush);
		auto made = gpu::Pipeline::create(*device_, info, "clear near edges");
		if (!made)
			return made.error();
		clear_ = std::move(*made);
		clear_sets_ = gpu::DescriptorSets(*device_, clear_, "clear near edges");
	}
	for (std::size_t i = 0; i < layers; ++i)
	{
		if (!isComputed(i))
			continue;
		auto set = clear_sets_.get(i);
		if (!set)
			return set.error();
		gpu::DescriptorWriter()
		    .storageImage(0, targets.layer(i))
		    .storageBuffer(1, edges.listed().handle())
		    .write(*device_, *set);
		layer_clear_sets_[i] = *set;
	}
	return Nothing{};
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

// Returns the sources from which each layer must be drawn.
std::vector<LayerPass::Drawn> LayerPass::wanted(const Scene& scene, const PicturePart& part, const glm::dvec2& jitter,
                                                bool only_edges) const
{
	// Without sheets there is one layer, and it is empty.
	std::vector<Drawn> layers(std::max<std::size_t>(1, scene.sheets.size()));
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
	{
		const SheetDrawing& sheet = scene.sheets[i];
		layers[i].records = sheet.records;
		layers[i].record_count = sheet.records ? sheet.records->count() : 0;
		layers[i].features = layerFeatures(scene, sheet);
		layers[i].only_edges = only_edges && isComputed(i);
		layers[i].push = layerPush(sheet, scene.camera, part, jitter);
		layers[i].push.mesh_half_width = 0.5f * lineWidth(scene.look);
	}
	return layers;
}

std::size_t LayerPass::record(VkCommandBuffer commands, const Scene& scene, const Targets& targets,
                              const glm::dvec2& jitter, const EdgeTiles* edges)
{
	std::vector<Drawn> layers = wanted(scene, targets.part(), jitter, edges != nullptr);
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
	gpu::ImageUse use = drawn_.empty()
	                        ? gpu::ImageUse{VK_IMAGE_LAYOUT_UNDEFINED, kSampledLayers.stages, kSampledLayers.access}
	                        : kSampledLayers;
	if (!computed.empty())
	{
		recordComputed(commands, scene, targets, jitter, edges, use, computed);
		use = kComputedLayers;
	}
	if (changed.size() > computed.size())
	{
		targets.values.transition(commands, use, gpu::kColorTarget);
		for (const std::size_t i : changed)
			if (!isComputed(i))
				recordLayer(commands, scene, targets, i, layers[i].push);
		use = gpu::kColorTarget;
	}
	targets.values.transition(commands, use, kSampledLayers);
	// Layers behind those of this scene keep what they hold.
	drawn_.resize(std::max(drawn_.size(), layers.size()));
	std::move(layers.begin(), layers.end(), drawn_.begin());
	return changed.size();
}

void LayerPass::recordClearAll(VkCommandBuffer commands, const Targets& targets,
                               std::span<const std::size_t> layers) const
{
	const VkClearColorValue empty{{shared::kEmptyValue, 0.0f, 0.0f, 0.0f}};
	for (const std::size_t i : layers)
	{
		const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, static_cast<std::uint32_t>(i), 1};
		vkCmdClearColorImage(commands, targets.values.handle(), VK_IMAGE_LAYOUT_GENERAL, &empty, 1, &range);
	}
}

void LayerPass::recordClearTiles(VkCommandBuffer commands, const EdgeTiles& edges,
                                 std::span<const std::size_t> layers) const
{
	for (const std::size_t i : layers)
	{
		clear_.bind(commands, layer_clear_sets_[i]);
		clear_.push(commands, edges.push());
		vkCmdDispatchIndirect(commands, edges.listed().handle(), 0);
	}
}

// Leaves all layers as kComputedLayers.
void LayerPass::recordComputed(VkCommandBuffer commands, const Scene& scene, const Targets& targets,
                               const glm::dvec2& jitter, const EdgeTiles* edges, const gpu::ImageUse& before,
                               std::span<const std::size_t> layers)
{
	targets.values.transition(commands, before, edges ? kComputedLayers : kClearedLayers);
	if (edges && !std::exchange(knows_edges_, true))
		raster_.recordKept(commands, scene, targets.part());
	// The sample before has read its lists.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
	                   VK_ACCESS_2_NONE, gpu::kUpdateStages, VK_ACCESS_2_NONE);
	raster_.recordStart(commands);
	if (edges)
		recordClearTiles(commands, *edges, layers);
	else
		recordClearAll(commands, targets, layers);
	gpu::memoryBarrier(commands, gpu::kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
	                   VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
	targets.values.transition(commands, edges ? kComputedLayers : kClearedLayers, kComputedLayers);
	raster_.record(commands, scene, layers, {targets.part(), jitter, raster_side_, edges != nullptr});
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

void LayerPass::recordLayer(VkCommandBuffer commands, const Scene& scene, const Targets& targets, std::size_t i,
                            const shared::LayerPush& push) const
{
	VkRenderingAttachmentInfo layer{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	layer.imageView = targets.layer(i);
	layer.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
	layer.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
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
		drawPages(commands, *scene.sheets[i].records, i, push);
	}
	vkCmdEndRendering(commands);
}

} // namespace vp::render
