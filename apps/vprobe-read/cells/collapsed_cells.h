#pragma once

class vtkUnstructuredGrid;

namespace vp::reader::cells
{

// Makes wedges, pyramids and tetrahedra of cells that list a corner several times, as Ansys writes SOLID186: quadratic
// hexahedra, wedges and pyramids whose edges or faces have collapsed. Their nodes are those of the smaller cell, and so
// are the shape functions that solvers use. `linear_too`: changes linear cells as well.
void uncollapse(vtkUnstructuredGrid* grid, bool linear_too);

} // namespace vp::reader::cells
