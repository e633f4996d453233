#include "parts.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <cstring>

namespace vprobe_paraview
{

namespace
{

int vtkTypeOf(vprobe::NumberType type)
{
	constexpr std::array kTypes{VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,     VTK_UNSIGNED_SHORT,
	                            VTK_INT,         VTK_UNSIGNED_INT,  VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
	                            VTK_FLOAT,       VTK_DOUBLE};
	return kTypes[static_cast<std::size_t>(type)];
}

vtkSmartPointer<vtkDataArray> copyOf(const vprobe::MeshArray& array)
{
	auto copy = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkTypeOf(array.type)));
	copy->SetName(array.name.c_str());
	copy->SetNumberOfComponents(array.components);
	copy->SetNumberOfTuples(static_cast<vtkIdType>(array.tuples));
	const auto numbers = static_cast<std::size_t>(copy->GetNumberOfValues());
	if (numbers > 0)
		std::memcpy(copy->GetVoidPointer(0), array.data, numbers * static_cast<std::size_t>(copy->GetDataTypeSize()));
	return copy;
}

template <class Array, class T>
vtkSmartPointer<Array> copyOf(std::span<const T> values, int components = 1)
{
	auto copy = vtkSmartPointer<Array>::New();
	copy->SetNumberOfComponents(components);
	copy->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
	if (!values.empty())
		std::memcpy(copy->GetPointer(0), values.data(), values.size_bytes());
	return copy;
}

} // namespace

vtkSmartPointer<vtkPolyData> polygonsOf(const vprobe::Mesh& mesh, const KeptGrid& grid)
{
	auto part = vtkSmartPointer<vtkPolyData>::New();
	vtkNew<vtkPoints> points;
	points->SetData(copyOf<vtkDoubleArray>(mesh.points(), 3));
	part->SetPoints(points);
	vtkNew<vtkCellArray> polygons;
	polygons->SetData(copyOf<vtkTypeInt64Array>(mesh.offsets()), copyOf<vtkTypeInt64Array>(mesh.connectivity()));
	part->SetPolys(polygons);
	for (const vprobe::MeshArray& array : mesh.arrays())
	{
		vtkFieldData* attributes = array.association == vprobe::Association::point
		                               ? static_cast<vtkFieldData*>(part->GetPointData())
		                               : part->GetCellData();
		attributes->AddArray(copyOf(array));
	}
	const auto cells = copyOf<vtkIdTypeArray>(mesh.cells());
	cells->SetName("vprobe:cell");
	const auto blocks = copyOf<vtkIntArray>(mesh.blocks());
	blocks->SetName("vprobe:block");
	for (vtkIdType i = 0; i < blocks->GetNumberOfTuples(); ++i)
	{
		const auto block = static_cast<std::size_t>(blocks->GetValue(i));
		cells->SetValue(i, grid.sourceCell(block, cells->GetValue(i)));
		blocks->SetValue(i, static_cast<int>(grid.leafOfBlock()[block]));
	}
	part->GetCellData()->AddArray(cells);
	part->GetCellData()->AddArray(blocks);
	return part;
}

} // namespace vprobe_paraview
