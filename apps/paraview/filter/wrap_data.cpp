#include "wrap_data.h"
#include "cell_kinds.h"
#include "wrap_lattice.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>

namespace vprobe_paraview
{

namespace
{

using vprobe::Numbers;
using vprobe::NumberType;

constexpr unsigned char kHidden =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;

NumberType typeOf(int vtk_type)
{
	switch (vtk_type)
	{
	case VTK_CHAR:
	case VTK_SIGNED_CHAR:
		return NumberType::int8;
	case VTK_UNSIGNED_CHAR:
		return NumberType::uint8;
	case VTK_SHORT:
		return NumberType::int16;
	case VTK_UNSIGNED_SHORT:
		return NumberType::uint16;
	case VTK_INT:
		return NumberType::int32;
	case VTK_UNSIGNED_INT:
		return NumberType::uint32;
	case VTK_LONG:
	case VTK_LONG_LONG:
	case VTK_ID_TYPE:
		return NumberType::int64;
	case VTK_UNSIGNED_LONG:
	case VTK_UNSIGNED_LONG_LONG:
		return NumberType::uint64;
	case VTK_FLOAT:
		return NumberType::float32;
	default:
		return NumberType::float64;
	}
}

// An array of the same values in one piece of memory, of whole bytes.
vtkSmartPointer<vtkDataArray> inOnePiece(vtkDataArray& array)
{
	if (array.HasStandardMemoryLayout() && array.GetDataType() != VTK_BIT)
		return &array;
	const int type = array.GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array.GetDataType();
	auto copy = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
	copy->DeepCopy(&array);
	return copy;
}

void addStamp(vtkObject* object, Stamps& stamps)
{
	stamps.push_back(reinterpret_cast<std::uint64_t>(object));
	stamps.push_back(object ? object->GetMTime() : 0);
}

vtkUnsignedCharArray* ghostMarks(vtkDataSetAttributes& attributes)
{
	return vtkUnsignedCharArray::SafeDownCast(attributes.GetArray(vtkDataSetAttributes::GhostArrayName()));
}

// Hides the cells of a lattice that have a hidden point.
void hideAtPoints(const vtkUnsignedCharArray& marks, const int* lattice, std::vector<bool>& hidden)
{
	const std::array<vtkIdType, 3> cells{lattice[0] - 1, lattice[1] - 1, lattice[2] - 1};
	vtkIdType point = 0;
	for (vtkIdType k = 0; k < lattice[2]; ++k)
		for (vtkIdType j = 0; j < lattice[1]; ++j)
			for (vtkIdType i = 0; i < lattice[0]; ++i)
			{
				if (!(marks.GetValue(point++) & vtkDataSetAttributes::HIDDENPOINT))
					continue;
				for (vtkIdType w = std::max<vtkIdType>(k - 1, 0); w <= std::min(k, cells[2] - 1); ++w)
					for (vtkIdType v = std::max<vtkIdType>(j - 1, 0); v <= std::min(j, cells[1] - 1); ++v)
						for (vtkIdType u = std::max<vtkIdType>(i - 1, 0); u <= std::min(i, cells[0] - 1); ++u)
							hidden[static_cast<std::size_t>((w * cells[1] + v) * cells[0] + u)] = true;
			}
}

} // namespace

Numbers numbersOf(vtkDataArray& array)
{
	const auto kept = std::make_shared<vtkSmartPointer<vtkDataArray>>(inOnePiece(array));
	vtkDataArray& values = **kept;
	const auto size = static_cast<std::size_t>(values.GetNumberOfValues());
	return {values.GetVoidPointer(0), size, typeOf(values.GetDataType()), kept};
}

std::vector<Leaf> leavesOf(vtkDataObject& input)
{
	std::vector<Leaf> leaves;
	const auto add = [&](std::uint32_t index, const char* name, vtkDataObject* object)
	{
		auto* data = vtkDataSet::SafeDownCast(object);
		if (data && data->GetNumberOfPoints() > 0 && data->GetNumberOfCells() > 0)
			leaves.push_back({index, name ? name : "", data});
	};
	if (auto* composite = vtkCompositeDataSet::SafeDownCast(&input))
	{
		const auto parts = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
		for (parts->InitTraversal(); !parts->IsDoneWithTraversal(); parts->GoToNextItem())
		{
			vtkInformation* about = parts->HasCurrentMetaData() ? parts->GetCurrentMetaData() : nullptr;
			add(parts->GetCurrentFlatIndex(), about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr,
			    parts->GetCurrentDataObject());
		}
	}
	else
		add(0, nullptr, &input);
	return leaves;
}

void addGridStamps(const Leaf& leaf, Stamps& stamps)
{
	vtkDataSet& data = *leaf.data;
	stamps.push_back(leaf.index);
	stamps.push_back(static_cast<std::uint64_t>(data.GetDataObjectType()));
	if (auto* set = vtkPointSet::SafeDownCast(&data))
	{
		addStamp(set->GetPoints() ? set->GetPoints()->GetData() : nullptr, stamps);
		stamps.push_back(set->GetPoints() ? set->GetPoints()->GetMTime() : 0);
	}
	addLatticeStamps(data, stamps);
	const auto add_cells = [&](vtkCellArray* cells)
	{
		addStamp(cells ? cells->GetConnectivityArray() : nullptr, stamps);
		addStamp(cells ? cells->GetOffsetsArray() : nullptr, stamps);
		stamps.push_back(cells ? cells->GetMTime() : 0);
	};
	if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data))
	{
		add_cells(grid->GetCells());
		addStamp(grid->GetCellTypesArray(), stamps);
		addStamp(grid->GetFaces(), stamps);
	}
	else if (auto* explicit_grid = vtkExplicitStructuredGrid::SafeDownCast(&data))
		add_cells(explicit_grid->GetCells());
	addStamp(ghostMarks(*data.GetCellData()), stamps);
	addStamp(ghostMarks(*data.GetPointData()), stamps);
}

void addFieldStamps(const Leaf& leaf, Stamps& stamps)
{
	for (vtkDataSetAttributes* attributes : {static_cast<vtkDataSetAttributes*>(leaf.data->GetPointData()),
	                                         static_cast<vtkDataSetAttributes*>(leaf.data->GetCellData())})
	{
		stamps.push_back(static_cast<std::uint64_t>(attributes->GetNumberOfArrays()));
		for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
			addStamp(attributes->GetAbstractArray(i), stamps);
	}
}

std::optional<std::vector<bool>> hiddenCells(vtkDataSet& data, const int* lattice)
{
	const vtkUnsignedCharArray* of_cells = ghostMarks(*data.GetCellData());
	const vtkUnsignedCharArray* of_points = lattice ? ghostMarks(*data.GetPointData()) : nullptr;
	if (!of_cells && !of_points)
		return std::nullopt;
	std::vector<bool> hidden(static_cast<std::size_t>(data.GetNumberOfCells()));
	if (of_cells)
		for (std::size_t c = 0; c < hidden.size(); ++c)
			hidden[c] = of_cells->GetValue(static_cast<vtkIdType>(c)) & kHidden;
	if (of_points)
		hideAtPoints(*of_points, lattice, hidden);
	const auto count = std::ranges::count(hidden, true);
	if (count == static_cast<std::ptrdiff_t>(hidden.size()))
		throw NoVolume(std::string("a ") + data.GetClassName() + " of ghost cells alone, or of hidden ones");
	return count > 0 ? std::optional(std::move(hidden)) : std::nullopt;
}

std::vector<vprobe::Field> fieldsOf(vtkDataSet& data)
{
	std::vector<vprobe::Field> fields;
	const std::optional<Crop> crop = cropOf(data);
	const auto add = [&](vtkDataSetAttributes& attributes, vprobe::Association association, vtkIdType count)
	{
		for (int i = 0; i < attributes.GetNumberOfArrays(); ++i)
		{
			vtkDataArray* array = attributes.GetArray(i); // null for strings
			// Ids of points mean nothing between the points.
			const bool are_ids = association == vprobe::Association::point && array == attributes.GetGlobalIds();
			if (!array || are_ids || array->GetNumberOfComponents() < 1 ||
			    array->GetName() == std::string_view(vtkDataSetAttributes::GhostArrayName()))
				continue;
			const std::string name = array->GetName() ? array->GetName() : "array " + std::to_string(i);
			if (array->GetNumberOfTuples() != count)
				throw Refused("the array " + name + " has " + std::to_string(array->GetNumberOfTuples()) +
				              " tuples where " + std::to_string(count) + " belong; remove it with Pass Arrays");
			vprobe::Numbers values = numbersOf(*array);
			const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
			if (crop)
				values = association == vprobe::Association::point ? crop->ofPoints(values, components)
				                                                   : crop->ofCells(values, components);
			fields.push_back({name, association, array->GetNumberOfComponents(), std::move(values)});
		}
	};
	add(*data.GetPointData(), vprobe::Association::point, data.GetNumberOfPoints());
	add(*data.GetCellData(), vprobe::Association::cell, data.GetNumberOfCells());
	return fields;
}

namespace
{

// The faces of polyhedra, as a stream with offsets for all cells.
void addFaces(vtkUnstructuredGrid& grid, vprobe::Unstructured& cells)
{
	if (!grid.GetFaces() || !grid.GetFaceLocations())
		throw Refused("polyhedra without faces; write the file anew with a program that keeps them");
	cells.face_stream = numbersOf(*grid.GetFaces());
	const auto end = static_cast<std::int64_t>(cells.face_stream.size);
	const auto count = static_cast<std::size_t>(grid.GetNumberOfCells());
	auto offsets = std::make_shared<std::vector<std::int64_t>>(count + 1, end);
	// Other cells have -1. Their faces begin, and end, where those of the next polyhedron begin.
	for (std::size_t c = count; c-- > 0;)
	{
		const vtkIdType at = grid.GetFaceLocations()->GetValue(static_cast<vtkIdType>(c));
		(*offsets)[c] = at < 0 ? (*offsets)[c + 1] : at;
	}
	cells.face_offsets = Numbers(std::shared_ptr<const std::vector<std::int64_t>>(std::move(offsets)));
}

vprobe::Unstructured cellsOf(vtkPointSet& data, vtkCellArray* cells, double tolerance)
{
	if (!data.GetPoints() || !cells)
		throw NoVolume(std::string("a ") + data.GetClassName() + " without points or cells");
	const auto count = static_cast<std::size_t>(data.GetNumberOfCells());
	vprobe::Unstructured grid;
	grid.coordinates = numbersOf(*data.GetPoints()->GetData());
	grid.offsets = numbersOf(*cells->GetOffsetsArray());
	grid.connectivity = numbersOf(*cells->GetConnectivityArray());
	grid.tolerance = tolerance;
	grid.checks_ids_later = true; // the first cut looks in passing
	auto* unstructured = vtkUnstructuredGrid::SafeDownCast(&data);
	if (unstructured)
		grid.types = numbersOf(*unstructured->GetCellTypesArray());
	else
		grid.types = Numbers(std::make_shared<const std::vector<unsigned char>>(count, VTK_HEXAHEDRON));
	const std::bitset<256> present = typesIn(grid.types);
	refuseOtherTypes(data, present, tolerance);
	if (unstructured && present[VTK_POLYHEDRON])
		addFaces(*unstructured, grid);
	if (const auto hidden = hiddenCells(data, nullptr))
	{
		const auto* types = static_cast<const unsigned char*>(grid.types.data);
		auto shown = std::make_shared<std::vector<unsigned char>>(types, types + count);
		for (std::size_t c = 0; c < count; ++c)
			if ((*hidden)[c])
				(*shown)[c] = VTK_EMPTY_CELL;
		grid.types = Numbers(std::shared_ptr<const std::vector<unsigned char>>(std::move(shown)));
	}
	return grid;
}

// Adds the degrees and rational weights of curved cells that are marked as such and have another name.
void addShapeArrays(vtkDataSet& data, std::vector<vprobe::Field>& fields)
{
	const auto add =
	    [&](vtkDataSetAttributes& attributes, vtkDataArray* array, const char* name, vprobe::Association association)
	{
		if (array && !attributes.GetArray(name))
			fields.push_back({name, association, array->GetNumberOfComponents(), numbersOf(*array)});
	};
	vtkDataSetAttributes& of_cells = *data.GetCellData();
	vtkDataSetAttributes& of_points = *data.GetPointData();
	add(of_cells, of_cells.GetHigherOrderDegrees(), "HigherOrderDegrees", vprobe::Association::cell);
	add(of_points, of_points.GetRationalWeights(), "RationalWeights", vprobe::Association::point);
}

decltype(vprobe::Block::grid) gridOf(vtkDataSet& data, double tolerance)
{
	if (auto lattice = latticeOf(data))
		return std::move(*lattice);
	if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data))
		return cellsOf(*grid, grid->GetCells(), tolerance);
	if (auto* grid = vtkExplicitStructuredGrid::SafeDownCast(&data))
		return cellsOf(*grid, grid->GetCells(), tolerance);
	throw NoVolume(std::string("a ") + data.GetClassName() +
	               " has no volume; an image, or a rectilinear, structured or unstructured grid has");
}

} // namespace

vprobe::Block blockOf(const Leaf& leaf, double tolerance)
{
	vprobe::Block block{gridOf(*leaf.data, tolerance), fieldsOf(*leaf.data), leaf.name};
	if (tolerance > 0.0)
		addShapeArrays(*leaf.data, block.fields);
	return block;
}

} // namespace vprobe_paraview
