#include "wrap_lattice.h"

#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <array>
#include <bit>

namespace vprobe_paraview
{

namespace
{

using vprobe::Numbers;

template <class T>
Numbers owned(std::vector<T> values)
{
	return Numbers(std::make_shared<const std::vector<T>>(std::move(values)));
}

std::array<std::size_t, 3> sizesOf(const int* lattice)
{
	return {static_cast<std::size_t>(lattice[0]), static_cast<std::size_t>(lattice[1]),
	        static_cast<std::size_t>(lattice[2])};
}

// The points of an image or a rectilinear grid, made.
Numbers madePoints(vtkDataSet& data)
{
	std::vector<double> points(3 * static_cast<std::size_t>(data.GetNumberOfPoints()));
	for (vtkIdType p = 0; p < data.GetNumberOfPoints(); ++p)
		data.GetPoint(p, points.data() + 3 * p);
	return owned(std::move(points));
}

Numbers pointsOf(vtkDataSet& data)
{
	auto* set = vtkPointSet::SafeDownCast(&data);
	return set ? numbersOf(*set->GetPoints()->GetData()) : madePoints(data);
}

// A lattice with cells that are not shown: hexahedra, the others empty.
vprobe::Unstructured hexahedra(vtkDataSet& data, const int* lattice, const std::vector<bool>& hidden)
{
	const std::int64_t nx = lattice[0], ny = lattice[1], nz = lattice[2];
	std::vector<std::int64_t> corners, offsets{0};
	std::vector<unsigned char> types;
	corners.reserve(8 * hidden.size());
	offsets.reserve(hidden.size() + 1);
	types.reserve(hidden.size());
	for (std::int64_t k = 0; k + 1 < nz; ++k)
		for (std::int64_t j = 0; j + 1 < ny; ++j)
			for (std::int64_t i = 0; i + 1 < nx; ++i)
			{
				const std::int64_t low = (k * ny + j) * nx + i, high = low + nx * ny;
				corners.insert(corners.end(),
				               {low, low + 1, low + nx + 1, low + nx, high, high + 1, high + nx + 1, high + nx});
				offsets.push_back(static_cast<std::int64_t>(corners.size()));
				types.push_back(hidden[types.size()] ? VTK_EMPTY_CELL : VTK_HEXAHEDRON);
			}
	vprobe::Unstructured grid;
	grid.coordinates = pointsOf(data);
	grid.types = owned(std::move(types));
	grid.offsets = owned(std::move(offsets));
	grid.connectivity = owned(std::move(corners));
	return grid;
}

Numbers axisOf(vtkDataArray& array)
{
	if (array.GetDataType() == VTK_DOUBLE)
		return numbersOf(array);
	std::vector<double> axis(static_cast<std::size_t>(array.GetNumberOfValues()));
	for (std::size_t i = 0; i < axis.size(); ++i)
		axis[i] = array.GetComponent(static_cast<vtkIdType>(i), 0);
	return owned(std::move(axis));
}

// The part of an axis that lies in the box.
Numbers partOf(const Numbers& axis, const Crop& box, std::size_t a)
{
	return {static_cast<const double*>(axis.data) + box.low[a], box.points[a], axis.type, axis.owner};
}

} // namespace

bool dimensionsOf(vtkDataSet& data, int* lattice)
{
	if (auto* image = vtkImageData::SafeDownCast(&data))
		image->GetDimensions(lattice);
	else if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data))
		grid->GetDimensions(lattice);
	else if (auto* grid = vtkStructuredGrid::SafeDownCast(&data))
		grid->GetDimensions(lattice);
	else
		return false;
	return true;
}

std::optional<decltype(vprobe::Block::grid)> latticeOf(vtkDataSet& data)
{
	std::array<int, 3> lattice{};
	if (!dimensionsOf(data, lattice.data()))
		return std::nullopt;
	if (lattice[0] < 2 || lattice[1] < 2 || lattice[2] < 2)
		throw NoVolume(std::string("a ") + data.GetClassName() + " that is flat; apply Slice to it");
	const auto hidden = hiddenCells(data, lattice.data());
	const std::optional<Crop> crop = cropOf(data);
	if (hidden && !crop)
		return hexahedra(data, lattice.data(), *hidden);
	const Crop box = crop.value_or(Crop{sizesOf(lattice.data()), {}, sizesOf(lattice.data())});
	if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data))
		return vprobe::Rectilinear{partOf(axisOf(*grid->GetXCoordinates()), box, 0),
		                           partOf(axisOf(*grid->GetYCoordinates()), box, 1),
		                           partOf(axisOf(*grid->GetZCoordinates()), box, 2)};
	auto* image = vtkImageData::SafeDownCast(&data);
	if (!image || !image->GetDirectionMatrix()->IsIdentity())
		return vprobe::Structured{box.points, crop ? box.ofPoints(pointsOf(data), 3) : pointsOf(data)};
	vprobe::Image3 made{.points = box.points};
	const int* extent = image->GetExtent();
	for (std::size_t a = 0; a < 3; ++a)
	{
		made.spacing[a] = image->GetSpacing()[a];
		made.origin[a] = image->GetOrigin()[a] + made.spacing[a] * (extent[2 * a] + static_cast<double>(box.low[a]));
	}
	return made;
}

void addLatticeStamps(vtkDataSet& data, Stamps& stamps)
{
	std::array<int, 3> lattice{};
	if (!dimensionsOf(data, lattice.data()))
		return;
	stamps.insert(stamps.end(), lattice.begin(), lattice.end());
	const auto add_array = [&](vtkDataArray* array)
	{
		stamps.push_back(reinterpret_cast<std::uint64_t>(array));
		stamps.push_back(array ? array->GetMTime() : 0);
	};
	if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data))
		for (vtkDataArray* axis : {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()})
			add_array(axis);
	if (auto* image = vtkImageData::SafeDownCast(&data))
	{
		for (int a = 0; a < 6; ++a)
			stamps.push_back(static_cast<std::uint64_t>(image->GetExtent()[a]));
		for (int a = 0; a < 3; ++a)
		{
			stamps.push_back(std::bit_cast<std::uint64_t>(image->GetOrigin()[a]));
			stamps.push_back(std::bit_cast<std::uint64_t>(image->GetSpacing()[a]));
		}
		for (int a = 0; a < 9; ++a)
			stamps.push_back(std::bit_cast<std::uint64_t>(image->GetDirectionMatrix()->GetData()[a]));
	}
}

} // namespace vprobe_paraview
