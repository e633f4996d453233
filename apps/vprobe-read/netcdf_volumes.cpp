#include "netcdf_volumes.h"

#include "is_one_of.h"
#include "netcdf_file.h"
#include "refusal.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkPointData.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace
{

// VTK's type for a type of whole numbers; 0 for one that VTK's reader takes as it is.
int wholeTypeOf(const NetcdfFile& file, int variable, nc_type type)
{
	switch (type)
	{
	case NC_BYTE:
		return isOneOf(file.text(variable, "_Unsigned"), {"true", "True", "TRUE"}) ? VTK_UNSIGNED_CHAR
		                                                                           : VTK_SIGNED_CHAR;
	case NC_UBYTE:
		return VTK_UNSIGNED_CHAR;
	case NC_USHORT:
		return VTK_UNSIGNED_SHORT;
	case NC_UINT:
		return VTK_UNSIGNED_INT;
	case NC_INT64:
		return VTK_LONG_LONG;
	case NC_UINT64:
		return VTK_UNSIGNED_LONG_LONG;
	default:
		return 0;
	}
}

nc_type typeOfVariable(const NetcdfFile& file, int variable)
{
	nc_type type = NC_NAT;
	NetcdfFile::check(nc_inq_vartype(file.id(), variable, &type));
	return type;
}

// Which of a time's values; the first where the dimension has no values of its own.
std::size_t stepOf(const NetcdfFile& file, const std::string& dimension, std::optional<double> time)
{
	const int axis = file.variable(dimension.c_str());
	if (!time)
		return 0;
	if (axis < 0 || file.dimensions(axis).size() != 1)
		return static_cast<std::size_t>(std::max(*time, 0.0)); // times are counted
	const std::vector<double> times = file.values(axis);
	const auto found = std::ranges::find(times, *time);
	return found == times.end() ? 0 : static_cast<std::size_t>(found - times.begin());
}

// With what the file says of missing values and of packing.
vtkSmartPointer<vtkDataArray> unpacked(const NetcdfFile& file, int variable, vtkDataArray* plain)
{
	std::vector<double> missing = file.numbers(variable, "_FillValue");
	for (const double value : file.numbers(variable, "missing_value"))
		missing.push_back(value);
	const std::vector<double> scale = file.numbers(variable, "scale_factor");
	const std::vector<double> offset = file.numbers(variable, "add_offset");
	if (missing.empty() && scale.empty() && offset.empty())
		return plain;
	auto array = vtkSmartPointer<vtkDoubleArray>::New();
	array->SetNumberOfValues(plain->GetNumberOfTuples());
	for (vtkIdType i = 0; i < plain->GetNumberOfTuples(); ++i)
	{
		const double value = plain->GetTuple1(i);
		const bool is_missing = std::ranges::find(missing, value) != missing.end();
		array->SetValue(i, is_missing ? std::numeric_limits<double>::quiet_NaN()
		                              : value * (scale.empty() ? 1.0 : scale[0]) + (offset.empty() ? 0.0 : offset[0]));
	}
	return array;
}

} // namespace

NetcdfVolumes netcdfVolumes(const std::string& path)
{
	const NetcdfFile file(path);
	NetcdfVolumes volumes;
	int count = 0;
	volumes.has_groups = nc_inq_grps(file.id(), &count, nullptr) == NC_NOERR && count > 0;
	for (const auto& [variable, name, type] : file.variables())
	{
		const auto sides = file.dimensions(variable);
		if (sides.size() < 3)
			continue;
		for (const auto& [side, length] : sides)
		{
			if (length == 0)
				volumes.empty[name] = side;
		}
		if (type == NC_CHAR || type >= NC_STRING)
			volumes.unread.push_back(name);
		else if (wholeTypeOf(file, variable, type) != 0)
			volumes.whole.push_back(name);
	}
	return volumes;
}

void addWholeNumbers(const std::string& name, const std::vector<std::string>& variables, std::optional<double> time,
                     vtkDataSet* data)
{
	const NetcdfFile file(name);
	for (const std::string& each : variables)
	{
		const int variable = file.variable(each.c_str());
		const auto sides = file.dimensions(variable);
		std::vector<std::size_t> starts(sides.size(), 0), counts;
		std::size_t count = 1;
		for (const auto& [side, length] : sides)
			counts.push_back(length);
		if (sides.size() > 3)
		{
			starts[0] = std::min(stepOf(file, sides[0].first, time), counts[0] - 1);
			counts[0] = 1;
		}
		for (const std::size_t length : counts)
			if (__builtin_mul_overflow(count, length, &count) || count > std::size_t(1) << 36)
				throw damaged("it has more values than there can be");
		const bool at_points = static_cast<vtkIdType>(count) == data->GetNumberOfPoints();
		if (!at_points && static_cast<vtkIdType>(count) != data->GetNumberOfCells())
			throw damaged(fmt::format("{} has {} values for {} points and {} cells", each, count,
			                          data->GetNumberOfPoints(), data->GetNumberOfCells()));
		const int type = wholeTypeOf(file, variable, typeOfVariable(file, variable));
		const auto plain = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
		plain->SetNumberOfTuples(static_cast<vtkIdType>(count));
		NetcdfFile::check(nc_get_vara(file.id(), variable, starts.data(), counts.data(), plain->GetVoidPointer(0)));
		const vtkSmartPointer<vtkDataArray> array = unpacked(file, variable, plain);
		array->SetName(each.c_str());
		if (const std::string units = file.text(variable, "units"); !units.empty())
			array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
		at_points ? data->GetPointData()->AddArray(array) : data->GetCellData()->AddArray(array);
	}
}
