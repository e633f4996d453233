#pragma once

#include "kept_grid.h"
#include "settings.h"

#include <vtkSmartPointer.h>

class vtkDataSet;
class vtkPolyData;

// Parts of the output.
namespace vprobe_paraview
{

// The polygons of a sheet or a contour with every array of the input; vprobe:cell and vprobe:block say from where each
// polygon is.
vtkSmartPointer<vtkPolyData> polygonsOf(const vprobe::Mesh& mesh, const KeptGrid& grid);

// The lines on the polygons where the array has these values.
vtkSmartPointer<vtkPolyData> contourLines(vtkPolyData& sheet, const Settings& settings);

// The paths of particles from all sheets, tufts with heads, with every array of the input at their points. Throws
// Refused.
vtkSmartPointer<vtkPolyData> pathsOf(const vprobe::Cut& cut, const KeptGrid& grid, const Settings& settings);

} // namespace vprobe_paraview
