#include "gpu/vulkan.h"

#include "render/passes/surface_pass.h"

#include "render/passes/picture_geometry.h"
#include "render/passes/surface_polygons.h"
#include "render/passes/targets.h"
#include "render/passes/value_params.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

static_assert(sizeof(shared::SurfacePush) == 96 &&
              sizeof(shared::SurfaceColors) == 4 * (4 + 21 * shared::kMaxSurfaces));

// A sheet in the surface's plane is in front, whatever rounding says: by some hundred steps of a float.
constexpr double kBehindSheets = 1.0 - 1e-5;

bool isOpaque(const ColorMap& map)
{
	const auto hides = [](const Color& color) { return color.a == 255; };
	return std::all_of(map.colors.begin(), map.colors.end(), hides) && hides(map.nan) && hides(map.below) &&
	       hides(map.above) &&
	       std::all_of(map.categories.begin(), map.categories.end(), [&](const auto& c) { return hides(c.color); });
}

// Returns true if nothing behind the surface can be seen.
bool isOpaque(const Scene& scene, const Surface& surface)
{
	if (surface.opacity < 1.0 || surface.thick)
		return false;
	return surface.values ? isOpaque(*valueStyle(scene, surface).colors) : surface.color.a == 255;
}

std::uint32_t surfaceFeatures(const Surface& surface)
{
	return (surface.lit ? shared::kSurfaceLit : 0u) | (surface.thick ? shared::kSurfaceThick : 0u) |
	       (surface.mesh ? shared::kComposeMesh : 0u) |
	       (surface.polygons && surface.polygons->polygon_values ? shared::kSurfacePolygonValues : 0u);
}

} // namespace

Status SurfacePass::putColors(const Scene& scene)
{
	if (Status room = makeRoom(*device_, params_, sizeof(shared::SurfaceColors), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
	                           "surface parameters");
	    !room)
		return room;
	auto& colors = *params_.mappedAs<shared::SurfaceColors>();
	colors = {};
	colors.contour_half_width = 0.5f * lineWidth(scene.look);
	const Vec3 light = lightDirection(scene.camera);
	for (int i = 0; i < 3; ++i)
		colors.light[i] = static_cast<float>(light[i]);
	ColorTables tables;
	styles_.clear();
	has_opaque_ = false;
	for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
	{
		const Surface& surface = scene.surfaces[i];
		shared::SheetParams& params = colors.sheets[i];
		params.opacity = static_cast<float>(std::clamp(surface.opacity, 0.0, 1.0));
		if (surface.values)
			setValues(params, valueStyle(scene, surface), tables);
		else
			setPlain(params, surface.color);
		styles_.push_back({surfaceFeatures(surface) | featuresOf(params), isOpaque(scene, surface)});
		has_opaque_ = has_opaque_ || styles_.back().is_opaque;
	}
	params_.flush();
	const std::vector<std::uint32_t> words = tables.take();
	return tables_.put(*device_, std::as_bytes(std::span(words)), VK_FORMAT_R32_UINT, "surface color tables");
}

Result<const gpu::Pipeline*> SurfacePass::pipelineFor(const Style& style)
{
	gpu::Pipeline& pipeline = pipelines_[style];
	if (pipeline)
		return &pipeline;
	gpu::GraphicsPipelineInfo info;
	info.vertex_shader = "render_surface.vert";
	info.fragment_shader = style.is_opaque ? "render_surface_opaque.frag" : "render_surface.frag";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}, {1, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {2, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},        {3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {4, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},       {5, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
	                 {6, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}, {7, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}};
	info.push_bytes = sizeof(shared::SurfacePush);
	info.constants = {{0, style.features}};
	if (style.is_opaque)
		info.color_formats = {OpaqueTarget::kFormat};
	info.depth_format = kDepthFormat;
	info.depth_test = true;
	info.depth_write = style.is_opaque;
	// At one depth the surface with the lowest number is the nearest. Opaque ones are drawn in this order; lists are
	// sorted.
	info.depth_compare = style.is_opaque ? VK_COMPARE_OP_GREATER : VK_COMPARE_OP_GREATER_OR_EQUAL;
	auto made = gpu::Pipeline::create(*device_, info, "surface");
	if (!made)
		return made.error();
	pipeline = std::move(*made);
	return &pipeline;
}

Status SurfacePass::writeSets(const Scene& scene, const FragmentLists& lists)
{
	part_sets_.clear();
	for (const Surface& surface : scene.surfaces)
	{
		if (!surface.polygons)
			continue;
		for (const SurfacePolygons::Part& part : surface.polygons->parts)
		{
			auto set = sets_->get(part_sets_.size());
			if (!set)
				return set.error();
			gpu::DescriptorWriter()
			    .texels(0, part.triangle_texels.handle())
			    .texels(1, part.vertex_texels.handle())
			    .storageImage(2, lists.heads().view())
			    .storageBuffer(3, lists.fragments().handle())
			    .storageBuffer(4, lists.counters().handle())
			    .uniformBuffer(5, params_.handle())
			    .texels(6, tables_.texels.handle())
			    .texels(7, part.across_texels ? part.across_texels.handle() : part.vertex_texels.handle())
			    .write(*device_, *set);
			part_sets_.push_back(*set);
		}
	}
	return Nothing{};
}

Status SurfacePass::prepare(const Scene& scene, const FragmentLists& lists, const EdgeMask* mask)
{
	if (scene.surfaces.size() > shared::kMaxSurfaces)
		return Error{ErrorKind::usage, fmt::format("{} surfaces are more than a picture takes; show up to {}",
		                                           scene.surfaces.size(), shared::kMaxSurfaces)};
	if (!device_->features().fragmentStoresAndAtomics)
		return Error{ErrorKind::device,
		             fmt::format("device {} lacks fragmentStoresAndAtomics, which surfaces are drawn with; leave "
		                         "`context` out or take another `device`",
		                         device_->name())};
	if (Status put = putColors(scene); !put)
		return put;
	if (Status ready = opaque_.prepare(*device_, lists.heads().extent(), has_opaque_); !ready)
		return ready;
	for (const Style& style : styles_)
	{
		auto pipeline = pipelineFor(style);
		if (!pipeline)
			return pipeline.error();
		// The layouts are alike, so a set of the first fits them all.
		if (!sets_)
			sets_.emplace(*device_, **pipeline, "surface");
	}
	std::vector<std::size_t> opaque;
	for (std::size_t i = 0; i < styles_.size(); ++i)
		if (styles_[i].is_opaque)
			opaque.push_back(i);
	if (Status ready = culling_.prepare(scene, opaque, mask, opaque_); !ready)
		return ready;
	return writeSets(scene, lists);
}

void SurfacePass::recordOpaque(VkCommandBuffer commands, const Scene& scene, const PicturePart& part,
                               const glm::dvec2& jitter, const EdgeMask* edges) const
{
	opaque_.recordBegin(commands, edges);
	record(commands, scene, part, jitter, true, edges && culling_.isUsed(), {});
	opaque_.recordEnd(commands);
}

void SurfacePass::recordNearEdges(VkCommandBuffer commands, const Scene& scene, const PicturePart& part) const
{
	if (culling_.isUsed())
		culling_.record(commands, scene, part);
}

void SurfacePass::recordLists(VkCommandBuffer commands, const Scene& scene, const PicturePart& part,
                              const FragmentLists& lists, const glm::dvec2& jitter, std::size_t sample,
                              std::uint32_t strip) const
{
	const VkRect2D rows = lists.strip(strip);
	const VkRenderingAttachmentInfo depth = opaque_.testedDepth();
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea = rows;
	rendering.layerCount = 1;
	rendering.pDepthAttachment = &depth;
	vkCmdBeginRendering(commands, &rendering);
	coverPart(commands, part.extent, rows);
	shared::SurfacePush push{};
	push.counter = lists.counter(sample, strip);
	push.capacity = lists.capacity();
	record(commands, scene, part, jitter, false, false, push);
	vkCmdEndRendering(commands);
}

// Those surfaces that are opaque, or the others. culled: only what was found near edges.
void SurfacePass::record(VkCommandBuffer commands, const Scene& scene, const PicturePart& part,
                         const glm::dvec2& jitter, bool opaque, bool culled, shared::SurfacePush push) const
{
	push.near_w = static_cast<float>(scene.camera.near * kBehindSheets);
	push.mesh_half_width = 0.5f * lineWidth(scene.look);
	std::size_t next_set = 0;
	for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
	{
		if (!scene.surfaces[i].polygons)
			continue;
		const SurfacePolygons& polygons = *scene.surfaces[i].polygons;
		const std::size_t first_set = next_set;
		next_set += polygons.parts.size();
		if (styles_[i].is_opaque != opaque)
			continue;
		const glm::dmat4 clip = clipMatrix(scene.camera, part, polygons.origin, jitter);
		const Vec3 eye = scene.camera.position - polygons.origin;
		for (int k = 0; k < 16; ++k)
			push.clip[k] = static_cast<float>(clip[k / 4][k % 4]);
		for (int k = 0; k < 3; ++k)
			push.eye[k] = static_cast<float>(eye[k]);
		push.surface = static_cast<std::uint32_t>(i);
		const gpu::Pipeline& pipeline = pipelines_.at(styles_[i]);
		for (std::size_t p = 0; p < polygons.parts.size(); ++p)
		{
			pipeline.bind(commands, part_sets_[first_set + p]);
			pipeline.push(commands, push);
			if (culled)
				culling_.recordDraw(commands, i, p);
			else
				vkCmdDraw(commands, 3 * polygons.parts[p].count, 1, 0, 0);
		}
	}
}

} // namespace vp::render
