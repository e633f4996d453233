#pragma once

#include "pack_partitions.h"

#include <hdf5.h>

namespace vp::reader::convert
{

// Writes what a pack tells of all parts of a grid at once: counts, boxes, and the points that a camera must see.
// root: the group of the data set. own: the one beside it (docs/FORMATS.md). Throws NoRoom.
void writePackHead(vtkUnstructuredGrid* grid, const PackDivision& division, const PackPartitions& partitions,
                   hid_t root, hid_t own);

} // namespace vp::reader::convert
