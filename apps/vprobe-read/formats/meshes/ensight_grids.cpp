#include "ensight_grids.h"

#include "vprobe-read/base/refusal.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace vp::reader::meshes
{

namespace
{

// VTK's base is seen from outside.
constexpr std::uint8_t kPenta6[] = {3, 4, 5, 0, 1, 2};
constexpr std::uint8_t kPenta15[] = {3, 4, 5, 0, 1, 2, 9, 10, 11, 6, 7, 8, 12, 13, 14};

// VTK's corner i is the element's node order[i]; without an order they are the same.
struct EnSightCell
{
	std::string_view type;
	int vtk;
	std::span<const std::uint8_t> order{};
};

constexpr EnSightCell kCells[] = {
    {"point", VTK_VERTEX},
    {"bar2", VTK_LINE},
    {"bar3", VTK_QUADRATIC_EDGE},
    {"tria3", VTK_TRIANGLE},
    {"tria6", VTK_QUADRATIC_TRIANGLE},
    {"quad4", VTK_QUAD},
    {"quad8", VTK_QUADRATIC_QUAD},
    {"tetra4", VTK_TETRA},
    {"tetra10", VTK_QUADRATIC_TETRA},
    {"pyramid5", VTK_PYRAMID},
    {"pyramid13", VTK_QUADRATIC_PYRAMID},
    {"hexa8", VTK_HEXAHEDRON},
    {"hexa20", VTK_QUADRATIC_HEXAHEDRON},
    {"penta6", VTK_WEDGE, kPenta6},
    {"penta15", VTK_QUADRATIC_WEDGE, kPenta15},
};

vtkSmartPointer<vtkDataArray> numbersOf(const std::vector<double>& values, int components, bool is_binary)
{
	const auto fill = [&](auto array) -> vtkSmartPointer<vtkDataArray>
	{
		array->SetNumberOfComponents(components);
		array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
		std::copy(values.begin(), values.end(), array->GetPointer(0));
		return array;
	};
	if (is_binary)
		return fill(vtkSmartPointer<vtkFloatArray>::New());
	return fill(vtkSmartPointer<vtkDoubleArray>::New());
}

vtkSmartPointer<vtkPoints> pointsOf(const EnSightPart& part, bool is_binary)
{
	auto points = vtkSmartPointer<vtkPoints>::New();
	points->SetData(numbersOf(part.coordinates, 3, is_binary));
	return points;
}

vtkSmartPointer<vtkUnsignedCharArray> marks(vtkIdType count)
{
	auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
	array->SetName(vtkDataSetAttributes::GhostArrayName());
	array->SetNumberOfTuples(count);
	array->FillValue(0);
	return array;
}

void insertPolygons(const EnSightElements& elements, vtkUnstructuredGrid* grid)
{
	const std::int64_t* node = elements.nodes.data();
	for (const std::int64_t size : elements.sizes)
	{
		const std::vector<vtkIdType> corners(node, node + size);
		grid->InsertNextCell(VTK_POLYGON, size, corners.data());
		node += size;
	}
}

void insertPolyhedra(const EnSightElements& elements, vtkUnstructuredGrid* grid)
{
	const std::int64_t* node = elements.nodes.data();
	const std::int64_t* face = elements.face_sizes.data();
	std::vector<vtkIdType> corners, faces;
	for (const std::int64_t size : elements.sizes)
	{
		corners.clear();
		faces.clear();
		for (std::int64_t f = 0; f < size; ++f, ++face)
		{
			faces.push_back(*face);
			faces.insert(faces.end(), node, node + *face);
			corners.insert(corners.end(), node, node + *face);
			node += *face;
		}
		std::sort(corners.begin(), corners.end());
		corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
		grid->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(corners.size()), corners.data(), size,
		                     faces.data());
	}
}

void insertElements(const EnSightElements& elements, vtkUnstructuredGrid* grid)
{
	if (elements.type == "nsided")
		return insertPolygons(elements, grid);
	if (elements.type == "nfaced")
		return insertPolyhedra(elements, grid);
	const auto cell = std::ranges::find(kCells, elements.type, &EnSightCell::type);
	if (cell == std::end(kCells))
		throw Refusal(fmt::format("elements of type {}, which are not read", elements.type));
	const auto nodes = static_cast<std::size_t>(ensightNodesOf(elements.type));
	std::vector<vtkIdType> corners(nodes);
	for (auto first = elements.nodes.begin(); first != elements.nodes.end();
	     first += static_cast<std::ptrdiff_t>(nodes))
	{
		for (std::size_t i = 0; i < nodes; ++i)
			corners[i] = first[static_cast<std::ptrdiff_t>(cell->order.empty() ? i : cell->order[i])];
		grid->InsertNextCell(cell->vtk, static_cast<vtkIdType>(nodes), corners.data());
	}
}

vtkSmartPointer<vtkDataSet> unstructuredOf(const EnSightPart& part, bool is_binary)
{
	auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
	grid->SetPoints(pointsOf(part, is_binary));
	grid->Allocate(part.cells());
	bool has_ghosts = false;
	for (const EnSightElements& elements : part.elements)
	{
		insertElements(elements, grid);
		has_ghosts |= elements.is_ghost;
	}
	if (!has_ghosts)
		return grid;
	const auto ghosts = marks(part.cells());
	vtkIdType cell = 0;
	for (const EnSightElements& elements : part.elements)
		for (std::int64_t i = 0; i < elements.count; ++i)
			ghosts->SetValue(cell++, elements.is_ghost ? vtkDataSetAttributes::DUPLICATECELL : 0);
	grid->GetCellData()->AddArray(ghosts);
	return grid;
}

vtkSmartPointer<vtkDataSet> blockOf(const EnSightPart& part, bool is_binary)
{
	std::array<int, 3> along;
	std::ranges::copy(part.along, along.begin());
	if (part.kind == EnSightPart::Kind::curvilinear)
	{
		auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
		grid->SetDimensions(along.data());
		grid->SetPoints(pointsOf(part, is_binary));
		return grid;
	}
	if (part.kind == EnSightPart::Kind::rectilinear)
	{
		auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
		grid->SetDimensions(along.data());
		grid->SetXCoordinates(numbersOf(part.axes[0], 1, is_binary));
		grid->SetYCoordinates(numbersOf(part.axes[1], 1, is_binary));
		grid->SetZCoordinates(numbersOf(part.axes[2], 1, is_binary));
		return grid;
	}
	auto grid = vtkSmartPointer<vtkImageData>::New();
	grid->SetDimensions(along.data());
	grid->SetOrigin(part.axes[0][0], part.axes[1][0], part.axes[2][0]);
	grid->SetSpacing(part.axes[0][1], part.axes[1][1], part.axes[2][1]);
	return grid;
}

void markHidden(const EnSightPart& part, vtkDataSet* grid)
{
	const auto mark =
	    [](const std::vector<std::int64_t>& flags, unsigned char bit, bool hides_zero, vtkDataSetAttributes* fields)
	{
		if (flags.empty())
			return;
		const auto hidden = marks(static_cast<vtkIdType>(flags.size()));
		for (std::size_t i = 0; i < flags.size(); ++i)
			if ((flags[i] == 0) == hides_zero)
				hidden->SetValue(static_cast<vtkIdType>(i), bit);
		fields->AddArray(hidden);
	};
	mark(part.blanks, vtkDataSetAttributes::HIDDENPOINT, true, grid->GetPointData());
	mark(part.ghosts, vtkDataSetAttributes::DUPLICATECELL, false, grid->GetCellData());
}

} // namespace

std::map<std::int64_t, vtkSmartPointer<vtkDataSet>> ensightGrids(const EnSightGeometry& geometry, bool is_binary)
{
	std::map<std::int64_t, vtkSmartPointer<vtkDataSet>> grids;
	for (const auto& [number, part] : geometry.parts)
	{
		const bool is_block = part.kind != EnSightPart::Kind::unstructured;
		grids[number] = is_block ? blockOf(part, is_binary) : unstructuredOf(part, is_binary);
		if (is_block)
			markHidden(part, grids[number]);
	}
	return grids;
}

void addEnSightArray(vtkDataSet* grid, const std::string& name, bool per_node, int components,
                     const std::vector<double>& values, bool is_binary)
{
	const auto array = numbersOf(values, components, is_binary);
	array->SetName(name.c_str());
	if (per_node)
		grid->GetPointData()->AddArray(array);
	else
		grid->GetCellData()->AddArray(array);
}

} // namespace vp::reader::meshes
