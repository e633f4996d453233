#include "gpu/vulkan.h"

#include "render/passes/picture_memory.h"

#include "classify/gpu_records.h"
#include "render/passes/edge_tiles.h"
#include "render/passes/opaque_target.h"
#include "render/passes/picture_geometry.h"
#include "render/passes/surface_polygons.h"
#include "render/passes/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vp::render
{

namespace
{

// The least height of a part. Every part draws all polygons again, so low parts cost much and save little memory.
constexpr std::uint32_t kMinRows = 16;

constexpr double kMiB = 1024.0 * 1024.0;

// Bytes of a picture.
struct Needs
{
	std::uint64_t layers = 0; // layers of values, bytes a row of pixels
	std::uint64_t others = 0; // sums, masks and depths, bytes a row of pixels
	std::uint64_t picture = 0;
	std::uint64_t polygons = 0;
};

std::uint64_t polygonBytes(const Scene& scene)
{
	constexpr std::uint64_t kCulledBytes = 13; // a triangle's indices and its bit (SurfaceCulling)
	const bool several = samplePattern(scene.look.samples).size() > 1;
	std::uint64_t bytes = 0;
	std::set<const void*> counted; // sheets and surfaces may share polygons
	for (const SheetDrawing& sheet : scene.sheets)
		if (sheet.records && counted.insert(sheet.records.get()).second)
			bytes += sizeof(shared::PolygonRecord) * sheet.records->count();
	for (const Surface& surface : scene.surfaces)
		if (surface.polygons && counted.insert(surface.polygons.get()).second)
			for (const SurfacePolygons::Part& part : surface.polygons->parts)
				bytes += part.triangles.size() + part.vertices.size() + part.across.size() +
				         (several ? kCulledBytes * part.count : 0);
	return bytes;
}

Needs needsOf(const Scene& scene)
{
	constexpr std::uint64_t kSum = 16; // or EdgeQuads, which take less
	constexpr std::uint64_t kDepth = 4;
	constexpr std::uint64_t kNearest = 8; // OpaqueTarget::kFormat
	constexpr std::uint64_t kHead = 4;    // FragmentLists
	const std::uint64_t width = scene.look.width;
	Needs needs;
	needs.layers = width * (scene.look.mesh ? 8 : 4) * std::max<std::size_t>(1, scene.sheets.size());
	needs.others = width * (kSum + kDepth); // with the outline's depths
	if (samplePattern(scene.look.samples).size() > 1)
		needs.others += width * kDepth; // EdgeMask
	if (!scene.surfaces.empty())
		needs.others += width * (kDepth + kNearest + kHead);
	needs.picture = 2 * 4 * width * scene.look.height; // and its copy for the host
	needs.polygons = polygonBytes(scene);
	return needs;
}

// So many rows have their squares near edges in a buffer of texels (EdgeMask).
std::uint64_t rowsOfTexels(const gpu::Device& device, const Scene& scene)
{
	if (samplePattern(scene.look.samples).size() == 1)
		return scene.look.height;
	const std::uint64_t lines = device.limits().maxTexelBufferElements / edgeTilesOver(scene.look.width);
	return lines * shared::kEdgeTile;
}

} // namespace

std::uint32_t PicturePlan::count() const
{
	const std::uint32_t step = first.extent.height - 2 * margin;
	return first.isWhole() ? 1 : (first.picture.height + step - 1) / step;
}

std::uint32_t PicturePlan::firstRow(std::uint32_t part) const
{
	const auto shown_from = static_cast<std::uint32_t>(shown(part).offset.y);
	return std::min(shown_from - std::min(shown_from, margin), first.picture.height - first.extent.height);
}

VkRect2D PicturePlan::shown(std::uint32_t part) const
{
	if (first.isWhole())
		return {{0, 0}, first.picture};
	const std::uint32_t step = first.extent.height - 2 * margin;
	const std::uint32_t from = part * step;
	return {{0, static_cast<std::int32_t>(from)}, {first.picture.width, std::min(step, first.picture.height - from)}};
}

Result<PicturePlan> planPicture(const gpu::Device& device, const Scene& scene, std::uint64_t fragment_bytes)
{
	const VkExtent2D picture{scene.look.width, scene.look.height};
	const Needs needs = needsOf(scene);
	const std::uint64_t kept = needs.picture + needs.polygons + (scene.surfaces.empty() ? 0 : fragment_bytes);
	const std::uint64_t budget = device.memoryBudget();
	const std::uint64_t rows_held = budget > kept ? (budget - kept) / (needs.layers + needs.others) : 0;
	const std::uint64_t rows = std::min(rows_held, rowsOfTexels(device, scene));
	if (rows >= picture.height)
		return PicturePlan{PicturePart::whole(picture), 0};
	const std::uint32_t margin = contourReach(scene.look) + 2;
	if (rows < kMinRows + 2 * margin)
		return Error{ErrorKind::out_of_memory,
		             fmt::format("a picture of {}x{} with {:.0f} MiB of polygons does not fit into the {:.0f} MiB of "
		                         "device memory that may be used; make `size` smaller or `device_memory` larger",
		                         picture.width, picture.height, needs.polygons / kMiB, budget / kMiB)};
	return PicturePlan{{picture, 0, {picture.width, static_cast<std::uint32_t>(rows)}}, margin};
}

std::string describe(const PicturePlan& plan, const gpu::Device& device, const Scene& scene)
{
	const Needs needs = needsOf(scene);
	const double rows = plan.first.picture.height;
	if (plan.first.extent.height == rowsOfTexels(device, scene))
		return fmt::format("the picture is drawn in {} parts, since a buffer of this device holds {} texels",
		                   plan.count(), device.limits().maxTexelBufferElements);
	return fmt::format("the picture is drawn in {} parts: {} sheets take {:.0f} MiB, sums and depths {:.0f} MiB, "
	                   "polygons {:.0f} MiB, of {:.0f} MiB of device memory (`device_memory`)",
	                   plan.count(), scene.sheets.size(), needs.layers * rows / kMiB, needs.others * rows / kMiB,
	                   needs.polygons / kMiB, device.memoryBudget() / kMiB);
}

} // namespace vp::render
