#pragma once

#include "render/annotate/canvas.h"
#include "render/scene/scene.h"

namespace vp::render
{

// Returns the color below a label: a sheet of this color and opacity (0 to 1) in front of the background. It is as
// opaque as the sheet, but at least 0.3.
Color labelGround(const Color& of_sheet, double opacity, const Background& background);

// Writes values on the contour lines of the scene's sheets, except where a nearer sheet hides them.
void writeContourLabels(const Scene& scene, const Layout& layout, Canvas& pen);

} // namespace vp::render
