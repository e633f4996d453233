#pragma once

#include "render/pen.h"
#include "render/scene.h"

namespace vp::render
{

// Values on the contour lines of the scene's sheets, where they are not behind a nearer sheet that hides them.
void writeContourLabels(const Scene& scene, const Layout& layout, Pen& pen);

} // namespace vp::render
