#pragma once

class vtkHyperTreeGrid;
class vtkUnstructuredGrid;

namespace vp::reader::vtk
{

// Gives the leaves of trees, as VTK's filter made voxels of them, their places in double precision: the filter makes
// single precision of them. False, and nothing is changed, if the voxels are not those of the leaves in their order.
bool setLeafPoints(vtkHyperTreeGrid* trees, vtkUnstructuredGrid* leaves);

} // namespace vp::reader::vtk
