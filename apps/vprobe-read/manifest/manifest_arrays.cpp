// The arrays of data sets in the manifest.
#include "manifest_writer.h"

#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace vp::reader::manifest
{

using grid::NumberType;
using nlohmann::json;

namespace
{

// Turns bits into bytes. Returns null for texts.
vtkSmartPointer<vtkDataArray> withBytesForBits(vtkDataArray* array)
{
	if (!array || array->GetDataType() != VTK_BIT)
		return array;
	auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
	bytes->DeepCopy(array);
	return bytes;
}

} // namespace

json describeLeftOut(const char* association, const std::string& name, NumberType type, int components)
{
	return {{"name", name},
	        {"association", association},
	        {"type", grid::numberTypeName(type)},
	        {"components", components},
	        {"left_out", true}};
}

// Returns the data set without the arrays that nobody asked for. Describes these in `left_out`.
vtkSmartPointer<vtkDataSet> Writer::withWishedArrays(vtkDataSet* given, json& left_out) const
{
	const auto data = vtkSmartPointer<vtkDataSet>::Take(given->NewInstance());
	data->ShallowCopy(given);
	bool has_shown = false;
	const auto leaveOut = [&](vtkDataSetAttributes* fields, const char* association)
	{
		for (int i = 0; i < fields->GetNumberOfArrays();)
		{
			vtkDataArray* array = fields->GetArray(i);
			const auto type = array ? arrays::numberTypeOfVtk(array->GetDataType()) : std::nullopt;
			const bool is_mark = array && array->GetName() &&
			                     std::string_view(array->GetName()) == vtkDataSetAttributes::GhostArrayName();
			if (!type || is_mark || !array->GetName())
			{
				++i;
				continue;
			}
			const std::string name = array->GetName();
			const bool shapes_cells = array == fields->GetHigherOrderDegrees() ||
			                          array == fields->GetRationalWeights() ||
			                          isOneOf(name, {"HigherOrderDegrees", "RationalWeights"});
			if (shapes_cells || wish_.wants(association, name, !has_shown))
				++i;
			else
			{
				left_out.push_back(describeLeftOut(association, name, *type, array->GetNumberOfComponents()));
				fields->RemoveArray(i);
			}
			has_shown = true;
		}
	};
	leaveOut(data->GetPointData(), "point");
	leaveOut(data->GetCellData(), "cell");
	return data;
}

json Writer::describeArrays(vtkDataSet* points, vtkDataSet* cells)
{
	json arrays = json::array();
	const auto warnAboutText = [&](const char* association, vtkAbstractArray* array)
	{
		const char* name = array && array->GetName() ? array->GetName() : "";
		std::string line = fmt::format("the {} array {} holds no numbers and is not shown", association, name);
		if (!hasWarned(line))
			warn(std::move(line));
	};
	const auto describeAll = [&](vtkFieldData* fields, const char* association, vtkIdType tuples)
	{
		for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
		{
			const vtkSmartPointer<vtkDataArray> array = withBytesForBits(fields->GetArray(i));
			if (!array)
				warnAboutText(association, fields->GetAbstractArray(i));
			const auto type = array ? arrays::numberTypeOfVtk(array->GetDataType()) : std::nullopt;
			if (!type || array == cells->GetCellGhostArray() || array == points->GetPointGhostArray())
				continue; // ghost marks have done their work
			const std::string name = array->GetName() ? array->GetName() : fmt::format("array {}", i);
			if (array->GetNumberOfTuples() != tuples)
				throw damaged(fmt::format("the {} array {} has {} tuples for {} {}s", association, name,
				                          array->GetNumberOfTuples(), tuples, association));
			const std::size_t bytes = static_cast<std::size_t>(array->GetNumberOfValues()) * byteSize(*type);
			json described;
			if (const arrays::StoredPlace* place = arrays::storedPlaceOf(array))
				described = {{"type", grid::numberTypeName(*type)},
				             {"stored", arrays::describeStored(*place, writer_)}};
			else
				described = writer_.write(*type, array->GetVoidPointer(0), bytes);
			described["name"] = name;
			described["association"] = association;
			described["components"] = array->GetNumberOfComponents();
			if (const char* units = arrays::unitsOf(array))
				described["units"] = units;
			arrays.push_back(std::move(described));
		}
	};
	describeAll(points->GetPointData(), "point", points->GetNumberOfPoints());
	describeAll(cells->GetCellData(), "cell", cells->GetNumberOfCells());
	return arrays;
}

} // namespace vp::reader::manifest
