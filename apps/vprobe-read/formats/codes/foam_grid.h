#pragma once

#include "foam_case.h"

#include <vtkSmartPointer.h>

#include <span>

class vtkDataArray;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace vp::reader::codes
{

// The cells of a mesh. Throws a Refusal if a cell has fewer than four faces.
vtkSmartPointer<vtkUnstructuredGrid> foamGrid(const FoamMesh& mesh);

// The faces of some patches, with points of their own.
vtkSmartPointer<vtkPolyData> foamFacesOf(const FoamMesh& mesh, std::span<const FoamPatch* const> patches);

// The values of a list, with the components in VTK's order, for so many elements.
vtkSmartPointer<vtkDataArray> foamArray(const FoamList& list, std::size_t elements, bool is_double);

// Copies an element of a list, with its components in VTK's order.
void foamTuple(const FoamList& list, std::size_t element, double* tuple);

} // namespace vp::reader::codes
