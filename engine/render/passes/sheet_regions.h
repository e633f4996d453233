#pragma once

#include "render/passes/picture_part.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <vector>

namespace vp::render
{

// A rectangle of pixels, and the sheets that may be seen in it.
struct SheetRegion
{
	VkRect2D pixels;
	std::vector<std::uint32_t> sheets; // ascending
};

// Parts the pixels into regions by the sheets' known bounds, wherever in their pixels samples lie. Every pixel is in
// one region. Composing a pixel costs time for each sheet that may be there.
std::vector<SheetRegion> sheetRegions(const Scene& scene, const PicturePart& part);

} // namespace vp::render
