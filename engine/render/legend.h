#pragma once

#include "render/pen.h"
#include "render/scene.h"

namespace vp::render
{

// The colour bar (or the bands, or the categories), its marks and the array's name, where the layout has room for them.
// The scene must have values.
void writeLegend(const Scene& scene, const Layout& layout, Pen& pen);

} // namespace vp::render
