#pragma once

#include "foam_case.h"

#include <vtkSmartPointer.h>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace vp::reader::codes
{

// The values that a field of cells has at the points: means of the faces of walls and patches around a point, else of
// its cells. `grid` has the mesh's cells. Throws FoamUnknown if the values at one of those patches are not known.
vtkSmartPointer<vtkDataArray> foamAverages(const FoamMesh& mesh, vtkUnstructuredGrid* grid, const FoamField& field,
                                           bool is_double);

} // namespace vp::reader::codes
