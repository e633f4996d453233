#include "new_nodes.h"

#include "vprobe-read/base/refusal.h"

#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::cells
{

namespace
{

// Returns the range of each component.
NewNodes::Ranges rangesOf(vtkDataArray* array)
{
	NewNodes::Ranges ranges;
	for (int c = 0; c < array->GetNumberOfComponents(); ++c)
	{
		double range[2];
		array->GetRange(range, c);
		ranges.push_back(range[0] <= range[1] ? std::pair{range[0], range[1]} : std::pair{0.0, 0.0});
	}
	return ranges;
}

} // namespace

double NewNodes::Values::kept(double value, int component) const
{
	if (!whole)
		return value;
	const auto [lo, hi] = range[static_cast<std::size_t>(component)];
	return std::isfinite(value) ? std::clamp(std::round(value), lo, hi) : 0.0;
}

NewNodes::NewNodes(vtkUnstructuredGrid* grid)
    : points_(vtkSmartPointer<vtkPoints>::New()), data_(vtkSmartPointer<vtkPointData>::New()),
      given_points_(grid->GetPoints())
{
	points_->SetDataType(given_points_->GetDataType());
	points_->DeepCopy(given_points_);
	vtkPointData* given = grid->GetPointData();
	for (int a = 0; a < given->GetNumberOfArrays(); ++a)
	{
		vtkDataArray* array = given->GetArray(a); // null for strings and variants
		if (!array)
			continue;
		if (array->GetNumberOfTuples() != given_points_->GetNumberOfPoints())
			throw damaged("a point array does not match the points");
		const auto grown = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
		grown->DeepCopy(array);
		data_->AddArray(grown);
		const bool whole = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
		arrays_.push_back({array, grown, whole, whole ? rangesOf(array) : Ranges()});
		width_ += static_cast<std::size_t>(array->GetNumberOfComponents());
	}
	sum_.resize(width_);
}

std::size_t NewNodes::Hash::operator()(const Key& key) const
{
	std::uint64_t hash = 0;
	for (const vtkIdType id : key)
	{
		hash = (hash ^ static_cast<std::uint64_t>(id)) * 0x9E3779B97F4A7C15u;
		hash ^= hash >> 29;
	}
	return hash;
}

NewNodes::Key NewNodes::keyOf(std::span<const vtkIdType> corners)
{
	Key key;
	key.fill(-1);
	std::copy(corners.begin(), corners.end(), key.begin());
	return key;
}

void NewNodes::enterCell(vtkIdList* points)
{
	cell_ = points;
	gathered_ = false;
}

void NewNodes::gather()
{
	cell_values_.resize(static_cast<std::size_t>(cell_->GetNumberOfIds()) * width_);
	double* value = cell_values_.data();
	for (vtkIdType n = 0; n < cell_->GetNumberOfIds(); ++n)
	{
		const vtkIdType point = cell_->GetId(n);
		given_points_->GetPoint(point, value);
		value += 3;
		for (const Values& array : arrays_)
			for (int c = 0; c < array.given->GetNumberOfComponents(); ++c)
				*value++ = array.given->GetComponent(point, c);
	}
	gathered_ = true;
}

const std::vector<double>& NewNodes::sum(std::span<const double> weights)
{
	if (!gathered_)
		gather();
	std::fill(sum_.begin(), sum_.end(), 0.0);
	for (std::size_t n = 0; n < weights.size(); ++n)
		if (weights[n] != 0.0) // also keeps a NaN to where it counts
			for (std::size_t v = 0; v < width_; ++v)
				sum_[v] += weights[n] * cell_values_[n * width_ + v];
	std::size_t v = 3;
	for (const Values& array : arrays_)
		for (int c = 0; c < array.given->GetNumberOfComponents(); ++c, ++v)
			sum_[v] = array.kept(sum_[v], c);
	return sum_;
}

vtkIdType NewNodes::add(std::span<const double> weights)
{
	const double* value = sum(weights).data();
	const vtkIdType id = points_->InsertNextPoint(value);
	value += 3;
	for (const Values& array : arrays_)
	{
		array.grown->InsertNextTuple(value);
		value += array.given->GetNumberOfComponents();
	}
	return id;
}

void NewNodes::place(vtkIdType point, std::span<const double> weights)
{
	const double* value = sum(weights).data();
	points_->SetPoint(point, value);
	value += 3;
	for (const Values& array : arrays_)
	{
		array.grown->SetTuple(point, value);
		value += array.given->GetNumberOfComponents();
	}
}

Vec3 NewNodes::at(vtkIdType point) const
{
	Vec3 place;
	points_->GetPoint(point, &place.x);
	return place;
}

std::size_t NewNodes::count() const
{
	return static_cast<std::size_t>(points_->GetNumberOfPoints());
}

} // namespace vp::reader::cells
