#pragma once

#include "render/passes/picture_part.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <glm/vec2.hpp>
#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vp::render
{

// Returns the places of a pixel's samples, from its center. Every sample has a row and a column of its own (a rank-1
// lattice), so edges of any direction get as many shades as there are samples.
std::vector<glm::dvec2> samplePattern(int samples);

// Returns the width of lines in pixels: about 1.5 at a height of 720, and in proportion for larger pictures.
float lineWidth(const Look& look);

// Returns how far from a pixel its color depends on others: contour lines look at neighbors (render_layer_colors.glsl).
std::uint32_t contourReach(const Look& look);

// The sheet's frame in clip space, moved by `jitter` pixels, and its window. Formed in double and about the sheet's
// origin, so that a scene far from the coordinates' origin loses nothing.
shared::LayerPush layerPush(const SheetDrawing& drawing, const Camera& camera, const PicturePart& part,
                            const glm::dvec2& jitter);

// The same for the compute rasterizer: frame, window, near plane and picture. Of a sheet seen edge on the way back from
// pixels is not finite.
shared::RasterPush rasterPush(const SheetDrawing& drawing, const Camera& camera, const PicturePart& part,
                              const glm::dvec2& jitter);

// a, b, c: near / w = a x + b y + c at pixel (x, y) of the sheet's plane, for 1 / w is linear in the picture. All zero
// for a sheet seen edge on.
std::array<double, 3> planeDepth(const probe::Sheet& sheet, const Camera& camera, const PicturePart& part);

// The window's four sides where they are drawn; none without a window.
std::vector<Segment> windowRim(const SheetDrawing& drawing);

// Towards the light, unit: it comes from above the viewer's left shoulder, so that faces at right angles differ.
Vec3 lightDirection(const Camera& camera);

// From offsets about `center` to clip space.
glm::dmat4 clipMatrix(const Camera& camera, const PicturePart& part, const Vec3& center, const glm::dvec2& jitter);

} // namespace vp::render
