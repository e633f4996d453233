#include "exodus_points.h"

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/netcdf_file.h"

#include <vtkCompositeDataIterator.h>
#include <vtkDoubleArray.h>
#include <vtkExodusIIReader.h>
#include <vtkIdTypeArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace vp::reader::wrapped
{

namespace
{

// The coordinates of all nodes, axis by axis; fewer than three axes in a flat file.
std::vector<std::vector<double>> exodusCoordinates(const hdf5::NetcdfFile& file)
{
	const std::size_t nodes = file.length("num_nodes");
	std::vector<std::vector<double>> axes;
	if (const int all = file.variable("coord"); all >= 0)
	{
		const auto sides = file.dimensions(all);
		for (std::size_t axis = 0; sides.size() == 2 && axis < std::min<std::size_t>(sides[0].second, 3); ++axis)
			axes.push_back(file.values(all, axis));
	}
	else
		for (const char* name : {"coordx", "coordy", "coordz"})
			if (const int one = file.variable(name); one >= 0)
				axes.push_back(file.values(one));
	for (const std::vector<double>& axis : axes)
		if (axis.size() != nodes)
			throw damaged("it has no coordinate for each node");
	return axes;
}

// True if they differ by no more than the rounding to single precision.
bool roundsTo(double exact, double single)
{
	return std::abs(exact - single) <= std::abs(exact) * 0x1p-23 + 0x1p-140 || !(std::isfinite(exact));
}

bool setPointsOf(vtkPointSet* data, vtkDataArray* ids, const std::vector<std::vector<double>>& axes)
{
	const vtkIdType count = data->GetNumberOfPoints();
	vtkNew<vtkDoubleArray> places;
	places->SetNumberOfComponents(3);
	places->SetNumberOfTuples(count);
	for (vtkIdType p = 0; p < count; ++p)
	{
		const auto node = static_cast<std::size_t>(ids->GetTuple1(p)) - 1;
		std::array<double, 3> place = {0.0, 0.0, 0.0}, was;
		data->GetPoint(p, was.data());
		for (std::size_t axis = 0; axis < axes.size(); ++axis)
		{
			if (node >= axes[axis].size() || !roundsTo(axes[axis][node], was[axis]))
				return false;
			place[axis] = axes[axis][node];
		}
		places->SetTuple(p, place.data());
	}
	vtkNew<vtkPoints> points;
	points->SetData(places);
	data->SetPoints(points);
	return true;
}

} // namespace

bool hasDoubleExodusPoints(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	for (const char* name : {"coord", "coordx", "coordy", "coordz"})
	{
		nc_type type = NC_NAT;
		if (const int variable = file.variable(name); variable >= 0)
			hdf5::NetcdfFile::check(nc_inq_vartype(file.id(), variable, &type));
		if (type == NC_DOUBLE)
			return true;
	}
	return false;
}

void numberExodusNodes(vtkDataSet* data)
{
	vtkNew<vtkIdTypeArray> numbers;
	numbers->SetName(vtkExodusIIReader::GetImplicitNodeIdArrayName());
	numbers->SetNumberOfValues(data->GetNumberOfPoints());
	std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + data->GetNumberOfPoints(), vtkIdType(1));
	data->GetPointData()->AddArray(numbers);
}

bool setExodusPoints(const std::string& path, vtkMultiBlockDataSet* objects)
{
	const std::vector<std::vector<double>> axes = exodusCoordinates(hdf5::NetcdfFile(path));
	const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(objects->NewIterator());
	bool all_set = true;
	for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
	{
		auto* data = vtkPointSet::SafeDownCast(leaf->GetCurrentDataObject());
		vtkDataArray* ids =
		    data ? data->GetPointData()->GetArray(vtkExodusIIReader::GetImplicitNodeIdArrayName()) : nullptr;
		if (data && data->GetNumberOfPoints() > 0)
			all_set &= ids && ids->GetNumberOfTuples() == data->GetNumberOfPoints() && setPointsOf(data, ids, axes);
	}
	return all_set;
}

} // namespace vp::reader::wrapped
