#pragma once

#include "render/passes/layer_colors.h"
#include "render/passes/picture_part.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vp::render
{

// The input of the composing pass: parameters, the tables that they point into, and the features (shared::kCompose
// bits) that the scene needs.
struct ComposeParams
{
	shared::ComposeParams params;
	std::vector<std::uint32_t> tables; // not empty
	LayerColors colors;                // colors of the sheets' layers; not empty
	std::uint32_t features = 0;
};

ComposeParams composeParams(const Scene& scene, const PicturePart& part);

// The planes of the scene's sheets as planeDepth() gives them, the same numbers for sheets that lie in one plane:
// rounding must not part what the order of the probe decides.
std::vector<std::array<double, 3>> planeDepths(const Scene& scene, const PicturePart& part);

} // namespace vp::render
