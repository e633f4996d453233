#pragma once

#include <vprobe/vprobe.h>

#include <bitset>

class vtkDataSet;

namespace vprobe_paraview
{

// The types of cells that occur.
std::bitset<256> typesIn(const vprobe::Numbers& types);

// Throws Refused for types that cannot be cut, and NoVolume if no cell has a volume. tolerance: of curved cells.
void refuseOtherTypes(vtkDataSet& data, const std::bitset<256>& present, double tolerance);

} // namespace vprobe_paraview
