#include "gpu/vulkan.h"

#include "render/passes/line_pass.h"

#include "render/passes/buffers.h"
#include "render/passes/picture_geometry.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::LineSegment) == 24 && sizeof(shared::LinePush) == 84 && sizeof(shared::TilesPush) == 12);

// Brings lines a little nearer, so that rounding does not hide the nearer half of edges within a sheet's plane.
constexpr float kDepthBias = 1.0005f;

void storePlace(float (&to)[3], const Vec3& from)
{
	for (int i = 0; i < 3; ++i)
		to[i] = static_cast<float>(from[i]);
}

} // namespace

Result<LinePass> LinePass::create(gpu::Device& device)
{
	gpu::GraphicsPipelineInfo info;
	info.vertex_shader = "render_line.vert";
	info.fragment_shader = "render_line.frag";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	info.push_bytes = sizeof(shared::LinePush);
	info.depth_format = kDepthFormat;
	info.depth_test = true;
	info.depth_write = true;
	info.depth_compare = VK_COMPARE_OP_GREATER;
	auto pipeline = gpu::Pipeline::create(device, info, "outline");
	if (!pipeline)
		return pipeline.error();
	LinePass pass;
	pass.device_ = &device;
	pass.pipeline_ = std::move(*pipeline);
	pass.sets_ = gpu::DescriptorSets(device, pass.pipeline_, "outline");
	return pass;
}

Status LinePass::prepareClearing(const EdgeTiles& edges)
{
	if (!clear_)
	{
		gpu::GraphicsPipelineInfo info;
		info.vertex_shader = "render_tiles.vert";
		info.fragment_shader = "render_line.frag";
		info.bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
		info.push_bytes = sizeof(shared::TilesPush);
		info.depth_format = kDepthFormat;
		info.depth_test = true;
		info.depth_write = true;
		info.depth_compare = VK_COMPARE_OP_ALWAYS;
		auto made = gpu::Pipeline::create(*device_, info, "clear near edges");
		if (!made)
			return made.error();
		clear_ = std::move(*made);
		clear_sets_ = gpu::DescriptorSets(*device_, clear_, "clear near edges");
	}
	auto set = clear_sets_.get(0);
	if (!set)
		return set.error();
	gpu::DescriptorWriter().storageBuffer(0, edges.listed().handle()).write(*device_, *set);
	clear_set_ = *set;
	return Nothing{};
}

Status LinePass::prepare(const Scene& scene, const EdgeTiles* edges)
{
	if (edges)
		if (Status ready = prepareClearing(*edges); !ready)
			return ready;
	std::vector<Segment> lines(scene.outline.begin(), scene.outline.end());
	for (const SheetDrawing& sheet : scene.sheets)
		if (sheet.rim)
		{
			const std::vector<Segment> rim = windowRim(sheet);
			lines.insert(lines.end(), rim.begin(), rim.end());
		}
	count_ = static_cast<std::uint32_t>(lines.size());
	if (count_ == 0)
		return Nothing{};
	Box box;
	for (const Segment& s : lines)
	{
		box.include(s.a);
		box.include(s.b);
	}
	center_ = box.center();
	if (Status room = makeRoom(*device_, segments_, sizeof(shared::LineSegment) * count_,
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "outline");
	    !room)
		return room;
	std::vector<shared::LineSegment> segments(count_);
	for (std::size_t i = 0; i < lines.size(); ++i)
	{
		storePlace(segments[i].a, lines[i].a - center_);
		storePlace(segments[i].b, lines[i].b - center_);
	}
	const std::size_t bytes = sizeof(segments[0]) * count_;
	if (kept_.size() != count_ || std::memcmp(kept_.data(), segments.data(), bytes) != 0)
		forget();
	std::memcpy(segments_.mapped(), segments.data(), bytes);
	segments_.flush();
	kept_ = std::move(segments);
	auto set = sets_.get(0);
	if (!set)
		return set.error();
	gpu::DescriptorWriter().storageBuffer(0, segments_.handle()).write(*device_, *set);
	set_ = *set;
	return Nothing{};
}

shared::LinePush LinePass::linePush(const Scene& scene, const PicturePart& part, const glm::dvec2& jitter) const
{
	const glm::dmat4 clip = clipMatrix(scene.camera, part, center_, jitter);
	shared::LinePush push{};
	for (int i = 0; i < 16; ++i)
		push.clip[i] = static_cast<float>(clip[i / 4][i % 4]);
	push.half_size[0] = 0.5f * static_cast<float>(part.extent.width);
	push.half_size[1] = 0.5f * static_cast<float>(part.extent.height);
	push.half_width = 0.5f * lineWidth(scene.look);
	push.near_w = static_cast<float>(scene.camera.near);
	push.depth_bias = kDepthBias;
	return push;
}

// Within a rendering into the depths.
void LinePass::recordClearTiles(VkCommandBuffer commands, const Targets& targets, const EdgeTiles& edges) const
{
	const VkExtent2D extent = targets.extent();
	const shared::TilesPush push{{2.0f / static_cast<float>(extent.width), 2.0f / static_cast<float>(extent.height)},
	                             edges.push().tiles_across};
	coverAll(commands, extent);
	clear_.bind(commands, clear_set_);
	clear_.push(commands, push);
	vkCmdDrawIndirect(commands, edges.listed().handle(), offsetof(shared::TileList, corners), 1, 0);
}

void LinePass::record(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter,
                      const EdgeTiles* edges)
{
	const Drawn wanted{count_, linePush(scene, targets.part(), jitter), edges != nullptr};
	if (drawn_ && !drawn_->only_edges && !wanted.only_edges && drawn_->count == count_ &&
	    std::memcmp(&drawn_->push, &wanted.push, sizeof(wanted.push)) == 0)
		return;
	drawn_ = wanted;
	const gpu::ImageUse& sampled = gpu::kSampled;
	targets.lines.transition(commands,
	                         {edges ? sampled.layout : VK_IMAGE_LAYOUT_UNDEFINED, sampled.stages, sampled.access},
	                         gpu::kDepthTarget);
	VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	depth.imageView = targets.lines.view();
	depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
	depth.loadOp = edges ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
	depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	depth.clearValue.depthStencil.depth = 0.0f;
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea.extent = targets.extent();
	rendering.layerCount = 1;
	rendering.pDepthAttachment = &depth;
	vkCmdBeginRendering(commands, &rendering);
	if (edges)
		recordClearTiles(commands, targets, *edges);
	if (count_ > 0)
	{
		coverAll(commands, targets.extent());
		pipeline_.bind(commands, set_);
		pipeline_.push(commands, wanted.push);
		vkCmdDraw(commands, count_ * shared::kSegmentCorners, 1, 0, 0);
	}
	vkCmdEndRendering(commands);
	targets.lines.transition(commands, gpu::kDepthTarget, sampled);
}

} // namespace vp::render
