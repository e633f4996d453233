#include "vtk_grids.h"

#include "exhaustive.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

namespace vp::test
{

vtkSmartPointer<vtkUnstructuredGrid> vtkCellsOf(const grid::Block& block, const grid::Field& field)
{
	auto made = vtkSmartPointer<vtkUnstructuredGrid>::New();
	visitGrid(
	    block,
	    [&](const auto& grid)
	    {
		    vtkNew<vtkPoints> points;
		    points->SetDataTypeToDouble();
		    vtkNew<vtkDoubleArray> values;
		    values->SetName(field.name.c_str());
		    for (PointId p = 0; p < grid.pointCount(); ++p)
		    {
			    const Vec3 x = grid.point(p);
			    points->InsertNextPoint(x.x, x.y, x.z);
			    values->InsertNextValue(field.value(grid.sourcePoint(p), 0));
		    }
		    made->SetPoints(points);
		    made->GetPointData()->SetScalars(values);

		    constexpr int types[] = {VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON}; // in the order of CellShape
		    vtkNew<vtkIdTypeArray> ids;
		    ids->SetName("cell");
		    for (CellId c = 0; c < grid.cellCount(); ++c)
		    {
			    const grid::CellPoints corners = grid.cellPoints(c);
			    const std::vector<vtkIdType> list(corners.begin(), corners.end());
			    made->InsertNextCell(types[static_cast<int>(grid.shape(c))], static_cast<vtkIdType>(list.size()),
			                         list.data());
			    ids->InsertNextValue(c);
		    }
		    made->GetCellData()->AddArray(ids);
	    });
	return made;
}

} // namespace vp::test
