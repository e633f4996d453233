#include "write/poly_data.h"

#include "write/unique_names.h"
#include "write/xml_text.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataSetAttributes.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

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

} // namespace

vtkSmartPointer<vtkDataArray> viewNumbers(const char* name, grid::NumberType type, int components, void* numbers,
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

void addColumns(std::vector<Column>& columns, vtkDataSetAttributes* attributes)
{
	UniqueNames names;
	for (Column& column : columns)
		attributes->AddArray(
		    viewValues(names.add(xmlText(column.name)).c_str(), column.type, column.components, column.bytes));
}

void writePolyData(vtkPolyData* data, AtomicFile& file)
{
	// To memory and from there to the file: VTK goes back in its stream to fill in offsets, which a pipe does not
	// allow, and reports a full disk less surely than AtomicFile.
	vtkNew<vtkXMLPolyDataWriter> writer;
	writer->SetInputData(data);
	writer->SetDataModeToAppended();
	writer->EncodeAppendedDataOff();
	writer->SetHeaderTypeToUInt64();
	writer->SetCompressorTypeToNone();
	writer->WriteToOutputStringOn();
	writer->Write();
	file.write(writer->GetOutputString());
}

} // namespace vp::write
