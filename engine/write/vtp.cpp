#include "write/poly_data.h"
#include "write/slice_formats.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace vp::write
{

void writeVtp(SliceTable& table, AtomicFile& file)
{
	using grid::NumberType;

	vtkNew<vtkPoints> points;
	points->SetData(viewValues("Points", NumberType::float64, 3, table.positions));
	vtkNew<vtkCellArray> polygons;
	polygons->SetData(viewValues("offsets", NumberType::int64, 1, table.polygon_starts),
	                  viewValues("connectivity", NumberType::int64, 1, table.polygon_vertices));
	vtkNew<vtkPolyData> slice;
	slice->SetPoints(points);
	slice->SetPolys(polygons);
	addColumns(table.vertex_columns, slice->GetPointData());
	addColumns(table.polygon_columns, slice->GetCellData());
	slice->GetCellData()->AddArray(viewValues("vprobe:cell", NumberType::int64, 1, table.cell));
	slice->GetCellData()->AddArray(viewValues("vprobe:block", NumberType::int32, 1, table.block));
	slice->GetCellData()->AddArray(viewValues("vprobe:sheet", NumberType::int32, 1, table.sheet));
	if (!table.contour.empty())
		slice->GetCellData()->AddArray(viewValues("vprobe:contour", NumberType::float64, 1, table.contour));
	writePolyData(slice, file);
}

} // namespace vp::write
