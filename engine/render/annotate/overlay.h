#pragma once

#include "render/annotate/font_atlas.h"
#include "render/annotate/layout.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vp::render
{

// Everything that is written over a picture, as triangles in pixels: the legend, the axes, title and caption.
struct Overlay
{
	std::shared_ptr<const FontAtlas> lettering; // its coverage is the texture of the triangles
	std::vector<ImDrawVert> vertices;
	std::vector<std::uint32_t> indices;
};

// kept: used from picture to picture; null: makes a lettering for this picture only.
Overlay makeOverlay(const Scene& scene, KeptLettering* kept = nullptr);

} // namespace vp::render
