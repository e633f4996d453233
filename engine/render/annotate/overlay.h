#pragma once

#include "render/annotate/font_atlas.h"
#include "render/annotate/layout.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vp::render
{

// What is written over a picture as triangles, in pixels: the legend, the axes, title and caption.
struct Overlay
{
	std::shared_ptr<const FontAtlas> lettering; // its coverage is the triangles' texture
	std::vector<ImDrawVert> vertices;
	std::vector<std::uint32_t> indices;
};

// kept: from picture to picture; null makes a lettering for this one.
Overlay makeOverlay(const Scene& scene, KeptLettering* kept = nullptr);

} // namespace vp::render
