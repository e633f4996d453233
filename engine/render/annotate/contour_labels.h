#pragma once

#include "render/annotate/canvas.h"
#include "render/scene/scene.h"

namespace vp::render
{

// Below a label: what is seen of a sheet of this color and opacity (0 to 1) before the background, as opaque as the
// sheet, 0.3 at the least.
Color labelGround(const Color& of_sheet, double opacity, const Background& background);

// Values on the contour lines of the scene's sheets, where they are not behind a nearer sheet that hides them.
void writeContourLabels(const Scene& scene, const Layout& layout, Canvas& pen);

} // namespace vp::render
