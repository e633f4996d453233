#pragma once

#include "probe/sheet.h"
#include "render/camera.h"
#include "shared/render_types.h"

#include <glm/vec2.hpp>
#include <vulkan/vulkan.h>

#include <array>
#include <vector>

namespace vp::render
{

// Where the samples of a pixel lie, from its centre: every sample has a row and a column of its own (a rank-1 lattice),
// so edges of any direction get as many shades as there are samples.
std::vector<glm::dvec2> samplePattern(int samples);

// The sheet's frame in clip space, moved by `jitter` pixels. Formed in double and about the sheet's origin, so that a
// scene far from the coordinates' origin loses nothing.
shared::LayerPush layerPush(const probe::Sheet& sheet, const Camera& camera, VkExtent2D extent,
                            const glm::dvec2& jitter);

// a, b, c: near / w = a x + b y + c at pixel (x, y) of the sheet's plane, for 1 / w is linear in the picture. All zero
// for a sheet seen edge on.
std::array<double, 3> planeDepth(const probe::Sheet& sheet, const Camera& camera, VkExtent2D extent);

// From offsets about `centre` to clip space.
glm::dmat4 clipMatrix(const Camera& camera, VkExtent2D extent, const Vec3& centre, const glm::dvec2& jitter);

} // namespace vp::render
