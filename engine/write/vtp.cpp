#include "write/slice_formats.h"
#include "write/unique_names.h"
#include "write/xml_text.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

namespace vp::write
{

namespace
{

int vtkTypeOf(grid::NumberType type)
{
	constexpr int types[] = {VTK_TYPE_INT8,   VTK_TYPE_UINT8, VTK_TYPE_INT16,  VTK_TYPE_UINT16,  VTK_TYPE_INT32,
	                         VTK_TYPE_UINT32, VTK_TYPE_INT64, VTK_TYPE_UINT64, VTK_TYPE_FLOAT32, VTK_TYPE_FLOAT64};
	return types[static_cast<int>(type)];
}

// A VTK array over memory that stays ours.
vtkSmartPointer<vtkDataArray> view(const char* name, grid::NumberType type, int components, void* numbers,
                                   std::size_t bytes)
{
	const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkTypeOf(type)));
	array->SetName(name);
	array->SetNumberOfComponents(components);
	constexpr int kStaysOurs = 1;
	if (bytes)
		array->SetVoidArray(numbers, static_cast<vtkIdType>(bytes / grid::byteSize(type)), kStaysOurs);
	return array;
}

template <class T>
vtkSmartPointer<vtkDataArray> view(const char* name, grid::NumberType type, int components, std::vector<T>& values)
{
	return view(name, type, components, values.data(), values.size() * sizeof(T));
}

void addColumns(std::vector<Column>& columns, vtkDataSetAttributes* attributes)
{
	UniqueNames names;
	for (Column& column : columns)
		attributes->AddArray(
		    view(names.add(xmlText(column.name)).c_str(), column.type, column.components, column.bytes));
}

} // namespace

void writeVtp(SliceTable& table, AtomicFile& file)
{
	using grid::NumberType;

	vtkNew<vtkPoints> points;
	points->SetData(view("Points", NumberType::float64, 3, table.positions));
	vtkNew<vtkCellArray> polygons;
	polygons->SetData(view("offsets", NumberType::int64, 1, table.polygon_starts),
	                  view("connectivity", NumberType::int64, 1, table.polygon_vertices));
	vtkNew<vtkPolyData> slice;
	slice->SetPoints(points);
	slice->SetPolys(polygons);
	addColumns(table.vertex_columns, slice->GetPointData());
	addColumns(table.polygon_columns, slice->GetCellData());
	slice->GetCellData()->AddArray(view("vprobe:cell", NumberType::int64, 1, table.cell));
	slice->GetCellData()->AddArray(view("vprobe:block", NumberType::int32, 1, table.block));
	slice->GetCellData()->AddArray(view("vprobe:sheet", NumberType::int32, 1, table.sheet));
	if (!table.contour.empty())
		slice->GetCellData()->AddArray(view("vprobe:contour", NumberType::float64, 1, table.contour));

	// To memory and from there to the file: VTK goes back in its stream to fill in offsets, which a pipe does not
	// allow, and reports a full disk less surely than AtomicFile.
	vtkNew<vtkXMLPolyDataWriter> writer;
	writer->SetInputData(slice);
	writer->SetDataModeToAppended();
	writer->EncodeAppendedDataOff();
	writer->SetHeaderTypeToUInt64();
	writer->SetCompressorTypeToNone();
	writer->WriteToOutputStringOn();
	writer->Write();
	file.write(writer->GetOutputString());
}

} // namespace vp::write
