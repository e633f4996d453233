#include "pack_times.h"

#include "vprobe-read/base/refusal.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace vp::reader::convert
{

namespace
{

bool areOneKind(vtkDataArray* a, vtkDataArray* b)
{
	return a->GetDataType() == b->GetDataType() && a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
	       a->GetNumberOfTuples() == b->GetNumberOfTuples();
}

bool areEqual(vtkDataArray* a, vtkDataArray* b)
{
	if (!a || !b || a == b)
		return a == b;
	const auto bytes =
	    static_cast<std::size_t>(a->GetNumberOfValues()) * static_cast<std::size_t>(a->GetDataTypeSize());
	return areOneKind(a, b) && (bytes == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0);
}

bool haveEqualCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
	constexpr const char* marks = "vtkGhostType"; // say which cells nobody sees
	return a->GetNumberOfPoints() == b->GetNumberOfPoints() && a->GetNumberOfCells() == b->GetNumberOfCells() &&
	       areEqual(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
	       areEqual(a->GetCellTypesArray(), b->GetCellTypesArray()) &&
	       areEqual(a->GetCells()->GetOffsetsArray(), b->GetCells()->GetOffsetsArray()) &&
	       areEqual(a->GetCells()->GetConnectivityArray(), b->GetCells()->GetConnectivityArray()) &&
	       areEqual(a->GetCellData()->GetArray(marks), b->GetCellData()->GetArray(marks)) &&
	       areEqual(a->GetPointData()->GetArray(marks), b->GetPointData()->GetArray(marks));
}

} // namespace

std::string PackTimes::nameOf(std::size_t time) const
{
	return fmt::format("at time {}", given_.times[time]);
}

vtkSmartPointer<vtkUnstructuredGrid> PackTimes::takeGrid(std::size_t time, TimesToPack::Read& read) const
{
	if (!areSeveral() || time == given_.kept)
		return kept_;
	for (vtkSmartPointer<vtkDataSet>& data : read)
	{
		const vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(data);
		if (!grid || !grid->GetPoints() || !haveEqualCells(grid, kept_))
			continue;
		data = nullptr; // another block may be like this one
		return grid;
	}
	throw Refusal(fmt::format("has other points or cells {} than {}, and packs hold grids that stand still; choose one "
	                          "time with --time",
	                          nameOf(time), nameOf(given_.kept)));
}

vtkDataArray* PackTimes::valuesAt(std::size_t time, vtkUnstructuredGrid* grid, vtkDataArray* kept, bool on_points) const
{
	if (grid == kept_)
		return kept;
	vtkDataSetAttributes* fields = grid->GetCellData();
	if (on_points)
		fields = grid->GetPointData();
	vtkDataArray* values = fields->GetArray(kept->GetName());
	if (!values)
		throw Refusal(fmt::format("has no array {} {}; name the arrays that all times have with --array, or choose one "
		                          "time with --time",
		                          kept->GetName(), nameOf(time)));
	if (!areOneKind(values, kept))
		throw Refusal(fmt::format("has another type of numbers in the array {} {} than {}; choose one time with --time",
		                          kept->GetName(), nameOf(time), nameOf(given_.kept)));
	return values;
}

} // namespace vp::reader::convert
