#pragma once

#include "wrap_data.h"

namespace vprobe_paraview
{

// The grid of an image, a rectilinear or a structured grid. Nothing for other data sets; throws Refused.
std::optional<decltype(vprobe::Block::grid)> latticeOf(vtkDataSet& data);
void addLatticeStamps(vtkDataSet& data, Stamps& stamps);

} // namespace vprobe_paraview
