#include "structured_blocks.h"

#include "vprobe-read/base/refusal.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <array>
#include <cmath>
#include <vector>

namespace vp::reader::cells
{

using grid::NumberType;
using nlohmann::json;

namespace
{

// Rows of at most this many numbers are converted at a time.
constexpr vtkIdType kChunk = 1 << 16;

json writeAsDouble(arrays::Writer& writer, vtkDataArray* array)
{
	std::vector<double> chunk;
	const int components = array->GetNumberOfComponents();
	writer.begin();
	for (vtkIdType first = 0; first < array->GetNumberOfTuples(); first += kChunk)
	{
		const vtkIdType end = std::min(first + kChunk, array->GetNumberOfTuples());
		chunk.clear();
		for (vtkIdType tuple = first; tuple < end; ++tuple)
			for (int component = 0; component < components; ++component)
				chunk.push_back(array->GetComponent(tuple, component));
		writer.append(chunk.data(), chunk.size() * sizeof(double));
	}
	return writer.end(NumberType::float64);
}

json writeTurnedImage(arrays::Writer& writer, vtkImageData* image)
{
	const int* extent = image->GetExtent();
	std::vector<double> row;
	writer.begin();
	for (int k = extent[4]; k <= extent[5]; ++k)
		for (int j = extent[2]; j <= extent[3]; ++j)
		{
			row.clear();
			for (int i = extent[0]; i <= extent[1]; ++i)
			{
				std::array<double, 3> point;
				image->TransformIndexToPhysicalPoint(i, j, k, point.data());
				row.insert(row.end(), point.begin(), point.end());
			}
			writer.append(row.data(), row.size() * sizeof(double));
		}
	return writer.end(NumberType::float64);
}

} // namespace

// If a direction matrix has ±1 on its diagonal, axes stay along x, y and z. The signs go into the spacing.
bool isAxisAligned(vtkMatrix3x3* direction)
{
	for (int row = 0; row < 3; ++row)
		for (int column = 0; column < 3; ++column)
		{
			const double wanted = row == column ? std::copysign(1.0, direction->GetElement(row, row)) : 0.0;
			if (!(std::abs(direction->GetElement(row, column) - wanted) < 1e-9))
				return false;
		}
	return true;
}

json describeImage(arrays::Writer& writer, vtkImageData* image)
{
	std::array<int, 3> points;
	image->GetDimensions(points.data());
	if (!isAxisAligned(image->GetDirectionMatrix()))
		return {{"kind", "curvilinear"}, {"points", points}, {"coordinates", writeTurnedImage(writer, image)}};

	std::array<double, 3> origin;
	std::array<double, 3> spacing;
	const int* extent = image->GetExtent();
	for (int axis = 0; axis < 3; ++axis)
	{
		spacing[axis] =
		    std::copysign(1.0, image->GetDirectionMatrix()->GetElement(axis, axis)) * image->GetSpacing()[axis];
		origin[axis] = image->GetOrigin()[axis] + extent[2 * axis] * spacing[axis];
	}
	return {{"kind", "image"}, {"points", points}, {"origin", origin}, {"spacing", spacing}};
}

json describeImageOf(arrays::Writer& writer, vtkImageData* piece, const std::array<int, 3>& first)
{
	json axes = json::array();
	const int* extent = piece->GetExtent();
	for (int axis = 0; axis < 3; ++axis)
	{
		const double spacing =
		    std::copysign(1.0, piece->GetDirectionMatrix()->GetElement(axis, axis)) * piece->GetSpacing()[axis];
		const double origin = piece->GetOrigin()[axis] + first[axis] * spacing;
		std::vector<double> places;
		for (int i = extent[2 * axis]; i <= extent[2 * axis + 1]; ++i)
			places.push_back(origin + static_cast<std::uint32_t>(i - first[axis]) * spacing);
		axes.push_back(writer.write(NumberType::float64, places.data(), places.size() * sizeof(double)));
	}
	return {{"kind", "rectilinear"}, {"axes", axes}};
}

json describeRectilinear(arrays::Writer& writer, vtkRectilinearGrid* grid)
{
	const std::array<vtkDataArray*, 3> axes = {grid->GetXCoordinates(), grid->GetYCoordinates(),
	                                           grid->GetZCoordinates()};
	json written = json::array();
	for (int axis = 0; axis < 3; ++axis)
	{
		if (!axes[axis] || axes[axis]->GetNumberOfComponents() != 1 ||
		    axes[axis]->GetNumberOfTuples() != grid->GetDimensions()[axis])
			throw damaged("the coordinates of an axis do not match its number of points");
		written.push_back(writeAsDouble(writer, axes[axis]));
	}
	return {{"kind", "rectilinear"}, {"axes", written}};
}

json describeCurvilinear(arrays::Writer& writer, vtkStructuredGrid* grid)
{
	std::array<int, 3> points;
	grid->GetDimensions(points.data());
	const vtkIdType wanted = vtkIdType(points[0]) * points[1] * points[2];
	if (!grid->GetPoints() || grid->GetNumberOfPoints() != wanted)
		throw damaged("the number of points does not match the dimensions");
	return {{"kind", "curvilinear"}, {"points", points}, {"coordinates", writeCoordinates(writer, grid->GetPoints())}};
}

json writeCoordinates(arrays::Writer& writer, vtkPoints* points)
{
	vtkDataArray* values = points->GetData();
	if (values->GetNumberOfComponents() != 3)
		throw damaged("points without three coordinates");
	const std::size_t count = static_cast<std::size_t>(values->GetNumberOfTuples()) * 3;
	if (values->GetDataType() == VTK_FLOAT)
		return writer.write(NumberType::float32, values->GetVoidPointer(0), count * sizeof(float));
	if (values->GetDataType() == VTK_DOUBLE)
		return writer.write(NumberType::float64, values->GetVoidPointer(0), count * sizeof(double));
	return writeAsDouble(writer, values);
}

} // namespace vp::reader::cells
