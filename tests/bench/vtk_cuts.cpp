#include "vtk_cuts.h"

#include <vtk3DLinearGridPlaneCutter.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdgesPlaneCutter.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCutter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#if __has_include(<vtkStructuredDataPlaneCutter.h>)
#include <vtkStructuredDataPlaneCutter.h>
#endif
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace vp::bench
{

namespace
{

template <class G>
vtkNew<vtkPoints> pointsOf(const G& grid)
{
	vtkNew<vtkPoints> points;
	points->SetDataTypeToFloat();
	points->SetNumberOfPoints(static_cast<vtkIdType>(grid.pointCount()));
	for (PointId p = 0; p < grid.pointCount(); ++p)
	{
		const Vec3 at = grid.point(p);
		points->SetPoint(p, at.x, at.y, at.z);
	}
	return points;
}

template <class T, class G>
vtkSmartPointer<T> withDimensions(const G& grid)
{
	auto made = vtkSmartPointer<T>::New();
	const auto points = grid.points();
	made->SetDimensions(static_cast<int>(points[0]), static_cast<int>(points[1]), static_cast<int>(points[2]));
	return made;
}

vtkSmartPointer<vtkDataSet> asVtk(const grid::UniformGrid& grid)
{
	auto image = withDimensions<vtkImageData>(grid);
	const Vec3 origin = grid.point(0);
	const Vec3 next = grid.pointAt(1, 1, 1);
	image->SetOrigin(origin.x, origin.y, origin.z);
	image->SetSpacing(next.x - origin.x, next.y - origin.y, next.z - origin.z);
	return image;
}

vtkSmartPointer<vtkDataSet> asVtk(const grid::RectilinearGrid& grid)
{
	auto made = withDimensions<vtkRectilinearGrid>(grid);
	for (int axis = 0; axis < 3; ++axis)
	{
		vtkNew<vtkFloatArray> coordinates;
		for (std::uint32_t i = 0; i < grid.points()[axis]; ++i)
			coordinates->InsertNextValue(static_cast<float>(grid.coordinate(axis, i)));
		axis == 0   ? made->SetXCoordinates(coordinates)
		: axis == 1 ? made->SetYCoordinates(coordinates)
		            : made->SetZCoordinates(coordinates);
	}
	return made;
}

vtkSmartPointer<vtkDataSet> asVtk(const grid::CurvilinearGrid& grid)
{
	auto made = withDimensions<vtkStructuredGrid>(grid);
	made->SetPoints(pointsOf(grid));
	return made;
}

// Cells in the program's own order, which lies well in memory for both.
vtkSmartPointer<vtkDataSet> asVtk(const grid::UnstructuredGrid& grid)
{
	auto made = vtkSmartPointer<vtkUnstructuredGrid>::New();
	made->SetPoints(pointsOf(grid));
	vtkNew<vtkUnsignedCharArray> types;
	vtkNew<vtkCellArray> cells;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		types->InsertNextValue(vtkType(grid.shape(c)));
		cells->InsertNextCell(grid.cellPoints(c).size);
		for (const PointId p : grid.cellPoints(c))
			cells->InsertCellPoint(p);
	}
	made->SetCells(types, cells);
	return made;
}

// One vertex for each cut edge, as this program has. VTK can do that from version 9.3 on.
template <class Cutter>
void mergePoints(Cutter& cutter)
{
	if constexpr (requires { cutter.MergePointsOn(); })
		cutter.MergePointsOn();
}

} // namespace

std::uint8_t vtkType(grid::CellShape shape)
{
	constexpr std::uint8_t kTypes[] = {VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON};
	return kTypes[static_cast<std::size_t>(shape)];
}

vtkSmartPointer<vtkDataSet> asVtk(const grid::Block& block)
{
	const auto made = std::visit([](const auto& grid) { return asVtk(grid); }, block.grid);
	if (block.fields.empty())
		return made;
	vtkNew<vtkFloatArray> scalars;
	scalars->SetName(block.fields[0].name.c_str());
	scalars->SetNumberOfTuples(made->GetNumberOfPoints());
	std::visit(
	    [&](const auto& grid)
	    {
		    for (PointId p = 0; p < grid.pointCount(); ++p)
			    scalars->SetValue(p, static_cast<float>(block.fields[0].value(grid.sourcePoint(p), 0)));
	    },
	    block.grid);
	made->GetPointData()->SetScalars(scalars);
	return made;
}

VtkCutter::VtkCutter(VtkCut kind, vtkDataSet* input) : plane_(vtkSmartPointer<vtkPlane>::New())
{
	const auto take = [&](auto cutter)
	{
		cutter->SetInputDataObject(input);
		cutter_ = cutter;
		return cutter;
	};
	switch (kind)
	{
	case VtkCut::cutter:
	{
		const auto cutter = take(vtkSmartPointer<vtkCutter>::New());
		cutter->SetCutFunction(plane_);
		cutter->GenerateTrianglesOff();
		break;
	}
	case VtkCut::plane_cutter:
	case VtkCut::treeless_cutter:
	{
		const auto cutter = take(vtkSmartPointer<vtkPlaneCutter>::New());
		cutter->SetPlane(plane_);
		cutter->SetBuildTree(kind == VtkCut::plane_cutter);
		mergePoints(*cutter);
		cutter->ComputeNormalsOff();
		break;
	}
	case VtkCut::linear_grid_cutter:
	{
		const auto cutter = take(vtkSmartPointer<vtk3DLinearGridPlaneCutter>::New());
		cutter->SetPlane(plane_);
		cutter->ComputeNormalsOff();
		break;
	}
	case VtkCut::structured_cutter:
	{
#if __has_include(<vtkStructuredDataPlaneCutter.h>)
		const auto cutter = take(vtkSmartPointer<vtkStructuredDataPlaneCutter>::New());
		cutter->SetPlane(plane_);
		cutter->ComputeNormalsOff();
#endif
		break;
	}
	case VtkCut::flying_edges_cutter:
	{
		const auto cutter = take(vtkSmartPointer<vtkFlyingEdgesPlaneCutter>::New());
		cutter->SetPlane(plane_);
		cutter->ComputeNormalsOff();
		break;
	}
	}
}

void VtkCutter::cut(const probe::Frame& plane)
{
	plane_->SetOrigin(plane.origin.x, plane.origin.y, plane.origin.z);
	plane_->SetNormal(plane.normal.x, plane.normal.y, plane.normal.z);
	cutter_->Update();
}

} // namespace vp::bench
