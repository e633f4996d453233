#pragma once

#include "render/layout.h"
#include "render/lettering.h"
#include "render/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vp::render
{

// What is written over a picture as triangles, in pixels: the legend, the axes, title and caption.
struct Overlay
{
	std::unique_ptr<Lettering> lettering; // its coverage is the triangles' texture
	std::vector<ImDrawVert> vertices;
	std::vector<std::uint32_t> indices;
};

Overlay makeOverlay(const Scene& scene);

} // namespace vp::render
