#pragma once

#include "grid/field.h"

namespace vp::grid
{

/// Returns the smallest finite shown value above 0, 0 if there is none. component: 0.. or kMagnitude. It looks at all
/// values, on all cores, unless the file says it.
double leastPositive(const Field& field, int component);

/// Returns true if the file says it.
bool knowsLeastPositive(const Field& field);

} // namespace vp::grid
