// VTKHDF 1.0, which VTK 9.1 reads and does not write: image data and unstructured grids of one piece.
#include "convert.h"
#include "hdf5_output.h"
#include "stored_layers.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

namespace
{

// A cut of a large image then reads the bricks that it meets. All along an axis are alike, so that the last ones are
// not mostly empty.
constexpr hsize_t kBrick = 32;
constexpr hsize_t kMinBytesInBricks = 1 << 20;
constexpr hsize_t kMostBytesAtOnce = hsize_t(1) << 30;

std::vector<hsize_t> bricksOf(const std::vector<hsize_t>& sides)
{
	std::vector<hsize_t> brick(sides);
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const hsize_t count = std::max<hsize_t>((sides[axis] + kBrick / 2) / kBrick, 1);
		brick[axis] = (sides[axis] + count - 1) / count;
	}
	return brick;
}

// Writes values of a lattice in bricks, those that stay in their file a few layers at a time.
void writeBricks(hid_t group, const char* name, vtkDataArray* array, const std::vector<hsize_t>& sides, int threads)
{
	const hid_t type = typeOf(array->GetDataType());
	const std::vector<hsize_t> brick = bricksOf(sides);
	const Handle space(H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr), H5Sclose);
	const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
	checked(H5Pset_chunk(properties, static_cast<int>(brick.size()), brick.data()));
	const Handle set(H5Dcreate2(group, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
	const arrays::StoredPlace* place = arrays::storedPlaceOf(array);
	if (!place)
	{
		checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, array->GetVoidPointer(0)));
		return;
	}
	arrays::ValueLayout layout;
	layout.components = static_cast<std::uint32_t>(array->GetNumberOfComponents());
	layout.type = *arrays::numberTypeOfVtk(array->GetDataType());
	for (std::size_t axis = 0; axis < 3; ++axis)
		layout.points[axis] = static_cast<std::uint32_t>(sides[2 - axis]);
	const StoredLayers layers(*place, layout, threads);
	// Whole bricks, and as many that a part of the file is read once, unless it is too deep for the memory.
	const hsize_t of_part = (layers.layersAtOnce() + brick[0] - 1) / brick[0];
	const hsize_t fitting = kMostBytesAtOnce / std::max<hsize_t>(brick[0] * layers.layerBytes(), 1);
	const hsize_t at_once = brick[0] * std::max<hsize_t>(std::min(of_part, fitting), 1);
	std::vector<std::byte> values;
	std::vector<hsize_t> begin(sides.size(), 0), count(sides);
	for (hsize_t first = 0; first < sides[0]; first += at_once)
	{
		begin[0] = first;
		count[0] = std::min(at_once, sides[0] - first);
		values.resize(count[0] * layers.layerBytes());
		layers.read(first, values);
		const Handle part(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
		checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr));
		checked(H5Dwrite(set, type, part, space, H5P_DEFAULT, values.data()));
	}
}

// `sides`: the sides of the lattice, the slowest first, or the number of tuples.
void writeArrays(hid_t root, const char* name, vtkDataSetAttributes* fields, const std::vector<hsize_t>& sides,
                 int threads)
{
	const Handle group = groupInOrder(root, name);
	for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
	{
		vtkDataArray* array = fields->GetArray(i);
		if (!array || !array->GetName() || typeOf(array->GetDataType()) < 0)
			continue;
		std::vector<hsize_t> all = sides;
		if (array->GetNumberOfComponents() > 1)
			all.push_back(static_cast<hsize_t>(array->GetNumberOfComponents()));
		const std::string plain = nameInGroup(group, array->GetName());
		const auto bytes =
		    static_cast<hsize_t>(array->GetNumberOfValues()) * static_cast<hsize_t>(array->GetDataTypeSize());
		if (arrays::storedPlaceOf(array) || (sides.size() == 3 && bytes > kMinBytesInBricks))
			writeBricks(group, plain.c_str(), array, all, threads);
		else
			writeValues(group, plain.c_str(), typeOf(array->GetDataType()), all, array->GetVoidPointer(0));
	}
}

void writeImage(hid_t root, vtkImageData* image, int threads)
{
	writeText(root, "Type", "ImageData");
	std::array<std::int64_t, 6> extent;
	std::copy_n(image->GetExtent(), 6, extent.begin());
	writeAttribute(root, "WholeExtent", H5T_NATIVE_INT64, extent);
	std::array<double, 3> numbers;
	image->GetOrigin(numbers.data());
	writeAttribute(root, "Origin", H5T_NATIVE_DOUBLE, numbers);
	image->GetSpacing(numbers.data());
	writeAttribute(root, "Spacing", H5T_NATIVE_DOUBLE, numbers);
	std::array<double, 9> direction;
	std::copy_n(image->GetDirectionMatrix()->GetData(), 9, direction.begin());
	if (direction != std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1})
		throw Refusal("has turned axes, which VTK's reader of VTKHDF leaves out; write a .vti");
	writeAttribute(root, "Direction", H5T_NATIVE_DOUBLE, direction);
	std::vector<hsize_t> points, cells;
	for (int axis = 2; axis >= 0; --axis)
	{
		points.push_back(static_cast<hsize_t>(image->GetDimensions()[axis]));
		cells.push_back(points.back() - 1);
	}
	writeArrays(root, "PointData", image->GetPointData(), points, threads);
	writeArrays(root, "CellData", image->GetCellData(), cells, threads);
}

void writeGrid(hid_t root, vtkUnstructuredGrid* grid)
{
	if (grid->GetFaces())
		throw Refusal("has polyhedra, for which VTKHDF 1.0 has no place; write a .vtu");
	writeText(root, "Type", "UnstructuredGrid");
	vtkNew<vtkCellArray> cells;
	cells->DeepCopy(grid->GetCells());
	cells->ConvertTo64BitStorage();
	vtkDataArray* connectivity = cells->GetConnectivityArray();
	const auto writeCount = [&](const char* name, vtkIdType count)
	{
		const std::int64_t number = count;
		writeValues(root, name, H5T_NATIVE_INT64, {1}, &number);
	};
	writeCount("NumberOfPoints", grid->GetNumberOfPoints());
	writeCount("NumberOfCells", grid->GetNumberOfCells());
	writeCount("NumberOfConnectivityIds", connectivity->GetNumberOfValues());
	const auto points = static_cast<hsize_t>(grid->GetNumberOfPoints());
	const auto count = static_cast<hsize_t>(grid->GetNumberOfCells());
	vtkDataArray* places = grid->GetPoints()->GetData();
	writeValues(root, "Points", typeOf(places->GetDataType()), {points, 3}, places->GetVoidPointer(0));
	writeValues(root, "Connectivity", H5T_NATIVE_INT64, {static_cast<hsize_t>(connectivity->GetNumberOfValues())},
	            connectivity->GetVoidPointer(0));
	writeValues(root, "Offsets", H5T_NATIVE_INT64, {count + 1}, cells->GetOffsetsArray()->GetVoidPointer(0));
	writeValues(root, "Types", H5T_NATIVE_UCHAR, {count}, grid->GetCellTypesArray()->GetVoidPointer(0));
	writeArrays(root, "PointData", grid->GetPointData(), {points}, 1);
	writeArrays(root, "CellData", grid->GetCellData(), {count}, 1);
}

} // namespace

void writeVtkHdf(vtkDataSet* data, const std::string& path, int threads)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
	auto* image = vtkImageData::SafeDownCast(data);
	auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
	if (!image && !grid)
		throw Refusal("is neither image data nor unstructured, and VTKHDF 1.0 holds nothing else; write a .vtm");
	Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
	{
		const Handle root(H5Gcreate2(file, "VTKHDF", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
		writeAttribute(root, "Version", H5T_NATIVE_INT64, std::array<std::int64_t, 2>{1, 0});
		image ? writeImage(root, image, threads) : writeGrid(root, grid);
	}
	if (H5Fflush(file, H5F_SCOPE_LOCAL) < 0)
		throw NoRoom(kNoRoom);
	file.close();
}

} // namespace vp::reader::convert
