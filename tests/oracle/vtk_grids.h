#pragma once

#include "grid/block.h"

#include <vtkSmartPointer.h>

class vtkUnstructuredGrid;

namespace vp::test
{

// A block's cells, one by one, as VTK has them, with the first component of a point field, under its name, and the cell
// array "cell" of their numbers. No polyhedra.
vtkSmartPointer<vtkUnstructuredGrid> vtkCellsOf(const grid::Block& block, const grid::Field& field);

} // namespace vp::test
