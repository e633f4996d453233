#pragma once

#include "base/vec.h"

namespace vp::interact
{

// Returns the size of a scene: the bounds' diagonal, or 1 if they have none.
double sizeOf(const Box& bounds);

// The round step in which snapped moves go: 1, 2 or 5 times a power of ten, about a fiftieth of the diagonal.
double roundStep(const Box& bounds);

// The multiple of the step (> 0) nearest to a value.
double rounded(double value, double step);

} // namespace vp::interact
