#include "gpu/vulkan.h"

#include "render/layer_pass.h"

#include "gpu/upload.h"
#include "render/picture_geometry.h"
#include "shared/slice_types.h"
#include "slice/gpu_records.h"

#include <algorithm>
#include <cstddef>

namespace vp::render
{

static_assert(sizeof(shared::LayerPush) == 68 && offsetof(shared::PolygonRecord, uv) == 8 &&
              offsetof(shared::PolygonRecord, value) == 56 && sizeof(shared::PolygonRecord) == 80);

namespace
{

std::uint32_t featuresOf(const Scene& scene, const SheetDrawing& sheet)
{
	return (sheet.window ? shared::kLayerWindow : 0u) | (scene.look.mesh ? shared::kLayerMesh : 0u);
}

} // namespace

Result<LayerPass> LayerPass::create(gpu::Device& device)
{
	LayerPass pass;
	pass.device_ = &device;
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
	info.colour_formats = {layerFormat((features & shared::kLayerMesh) != 0)};
	info.constants = {{0, features}};
	auto made = gpu::Pipeline::create(*device_, info, "layer");
	if (!made)
		return made.error();
	pipeline = std::move(*made);
	return &pipeline;
}

Status LayerPass::prepare(const Scene& scene)
{
	page_sets_.clear();
	sheet_pipelines_.clear();
	std::uint32_t largest = 0;
	for (const SheetDrawing& sheet : scene.sheets)
	{
		auto pipeline = pipelineFor(featuresOf(scene, sheet));
		if (!pipeline)
			return pipeline.error();
		sheet_pipelines_.push_back(*pipeline);
		if (!sheet.records)
			continue;
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

void LayerPass::record(VkCommandBuffer commands, const Scene& scene, const Targets& targets,
                       const glm::dvec2& jitter) const
{
	const gpu::ImageUse sampled{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
	                            VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
	targets.values.transition(commands, {VK_IMAGE_LAYOUT_UNDEFINED, sampled.stages, sampled.access},
	                          gpu::kColourTarget);
	std::size_t set = 0;
	// Without sheets there is one layer, and it is empty.
	for (std::size_t i = 0; i < std::max<std::size_t>(1, scene.sheets.size()); ++i)
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
			const auto& records = scene.sheets[i].records;
			coverAll(commands, targets.extent());
			if (indices_)
				vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
			shared::LayerPush push = layerPush(scene.sheets[i], scene.camera, targets.extent(), jitter);
			push.mesh_half_width = 0.5f * lineWidth(scene.look);
			const gpu::Pipeline& pipeline = *sheet_pipelines_[i];
			for (const auto& page : records->pages)
			{
				pipeline.bind(commands, page_sets_[set++]);
				pipeline.push(commands, push);
				vkCmdDrawIndexed(commands, page.count * shared::kRecordCorners, 1, 0, 0, 0);
			}
		}
		vkCmdEndRendering(commands);
	}
	targets.values.transition(commands, gpu::kColourTarget, sampled);
}

} // namespace vp::render
