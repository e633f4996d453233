#pragma once

#include "grid/block.h"
#include "probe/transform.h"

#include <vtkSmartPointer.h>

class vtkAlgorithm;
class vtkDataSet;
class vtkPlane;

namespace vp::bench
{

std::uint8_t vtkType(grid::CellShape shape);

// The grid of a block as VTK has it, with its first point array, where it has one, as scalars.
vtkSmartPointer<vtkDataSet> asVtk(const grid::Block& block);

// VTK's ways to cut by a plane.
enum class VtkCut
{
	cutter,             // vtkCutter
	plane_cutter,       // vtkPlaneCutter with its sphere tree, built at the first cut
	treeless_cutter,    // vtkPlaneCutter without
	linear_grid_cutter, // vtk3DLinearGridPlaneCutter: linear cells of unstructured grids only
	structured_cutter,  // vtkStructuredDataPlaneCutter: structured grids, from VTK 9.3 on
	flying_edges_cutter // vtkFlyingEdgesPlaneCutter: images only
};

// True if this VTK has vtkStructuredDataPlaneCutter.
constexpr bool kHasStructuredCutter =
#if __has_include(<vtkStructuredDataPlaneCutter.h>)
    true;
#else
    false;
#endif

// A cutter of VTK's and the plane that it cuts by; moved and cut again for each measurement.
class VtkCutter
{
public:
	VtkCutter(VtkCut kind, vtkDataSet* input);

	void cut(const probe::Frame& plane);

private:
	vtkSmartPointer<vtkPlane> plane_;
	vtkSmartPointer<vtkAlgorithm> cutter_;
};

} // namespace vp::bench
