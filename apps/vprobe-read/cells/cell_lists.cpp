#include "cell_lists.h"

#include "curved_cells.h"
#include "read/cell_types.h"
#include "source_cell.h"
#include "visible_cells.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdTypeArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <span>
#include <vector>

namespace vp::reader::cells
{

using grid::NumberType;
using nlohmann::json;

namespace
{

template <class T>
struct Lists
{
	std::span<const T> offsets;
	std::span<const T> connectivity;

	T size(std::size_t cell) const { return offsets[cell + 1] - offsets[cell]; }
};

template <class T>
std::span<const T> spanOf(vtkDataArray* array)
{
	return {static_cast<const T*>(array->GetVoidPointer(0)), static_cast<std::size_t>(array->GetNumberOfValues())};
}

template <class T>
Lists<T> listsOf(vtkCellArray* cells)
{
	return {spanOf<T>(cells->GetOffsetsArray()), spanOf<T>(cells->GetConnectivityArray())};
}

template <class T>
void refuseBadOffsets(const Lists<T>& lists, std::size_t cells)
{
	if (lists.offsets.size() != cells + 1 || lists.offsets[0] != 0 ||
	    lists.offsets[cells] != static_cast<T>(lists.connectivity.size()))
		throw damaged("the cell offsets do not match the cells");
	for (std::size_t c = 0; c < cells; ++c)
		if (lists.offsets[c] > lists.offsets[c + 1])
			throw damaged("the cell offsets do not rise");
}

// Chooses the types to hand over: hidden cells and cells that cannot be sliced become empty. Returns false if nothing
// is left.
template <class T>
bool chooseTypes(std::vector<std::uint8_t>& types, const Lists<T>& lists, vtkUnsignedCharArray* ghosts,
                 CellCounts& counts, bool curved)
{
	std::size_t left = 0;
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		const std::uint8_t type = types[c];
		const int dimension = read::cellDimension(type);
		if (dimension < 0)
			throw damaged("cell " + std::to_string(c) + " has the unknown type " + std::to_string(type));
		if (dimension < 3)
		{
			++counts.flat;
			continue;
		}
		const T wanted = static_cast<T>(read::slicedCellSize(type));
		if (ghosts && (ghosts->GetValue(static_cast<vtkIdType>(c)) & kHiddenCellBits))
		{
			++counts.hidden;
			types[c] = read::kEmptyCell;
		}
		else if (!read::canBeSliced(type) && !(curved && isCurved(type)))
		{
			++counts.not_sliced[type];
			types[c] = read::kEmptyCell;
		}
		else if (lists.size(c) < wanted)
			throw damaged("cell " + std::to_string(c) + " of type " + std::to_string(type) + " lists " +
			              std::to_string(lists.size(c)) + " points");
		else
		{
			counts.trimmed += wanted > 0 && lists.size(c) > wanted;
			++left;
		}
	}
	return left > 0;
}

// Returns true if the offsets follow from the types.
template <class T>
bool areAlike(std::span<const std::uint8_t> types, const Lists<T>& lists)
{
	const auto size = static_cast<T>(read::slicedCellSize(types[0]));
	if (size == 0 || !std::equal(types.begin() + 1, types.end(), types.begin()))
		return false;
	T others = 0;
	for (std::size_t c = 0; c < types.size(); ++c)
		others |= lists.size(c) ^ size;
	return others == 0;
}

// Writes offsets and connectivity without the points that a cell lists beyond those of its type. Some writers leave
// mid-side nodes there.
template <class T>
void writeTrimmed(arrays::Writer& writer, std::span<const std::uint8_t> types, const Lists<T>& lists, json& cells)
{
	std::vector<std::int64_t> offsets = {0};
	std::vector<std::int64_t> connectivity;
	offsets.reserve(lists.offsets.size());
	connectivity.reserve(lists.connectivity.size());
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		const T wanted = static_cast<T>(read::slicedCellSize(types[c]));
		const T size = wanted > 0 ? wanted : types[c] == read::kEmptyCell ? 0 : lists.size(c);
		for (T i = 0; i < size; ++i)
			connectivity.push_back(lists.connectivity[lists.offsets[c] + i]);
		offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
	}
	cells["offsets"] = arrays::writeInt64(writer, std::span<const std::int64_t>(offsets));
	cells["connectivity"] = arrays::writeIds(writer, std::span<const std::int64_t>(connectivity));
}

// Writes for each polyhedron the number of faces, then for each face its size and points. VTK keeps them in one array,
// with a location for each cell.
void writeFaces(arrays::Writer& writer, std::span<const std::uint8_t> types, vtkUnstructuredGrid* grid, json& cells)
{
	std::vector<std::int64_t> offsets = {0};
	std::vector<std::int64_t> stream;
	offsets.reserve(types.size() + 1);
	stream.reserve(grid->GetFaces() ? static_cast<std::size_t>(grid->GetFaces()->GetNumberOfValues()) : 0);
	for (std::size_t c = 0; c < types.size(); ++c)
	{
		if (types[c] == read::kPolyhedron)
		{
			const auto faces = polyhedronFaces(grid, static_cast<vtkIdType>(c));
			stream.insert(stream.end(), faces.begin(), faces.end());
		}
		offsets.push_back(static_cast<std::int64_t>(stream.size()));
	}
	cells["face_offsets"] = arrays::writeInt64(writer, std::span<const std::int64_t>(offsets));
	cells["face_stream"] = arrays::writeInt64(writer, std::span<const std::int64_t>(stream));
}

template <class T>
json writeCellsAs(arrays::Writer& writer, vtkUnstructuredGrid* grid, CellCounts& counts, bool curved)
{
	const auto given = spanOf<std::uint8_t>(grid->GetCellTypesArray());
	const auto lists = listsOf<T>(grid->GetCells());
	refuseBadOffsets(lists, given.size());

	std::vector<std::uint8_t> types(given.begin(), given.end());
	vtkUnsignedCharArray* ghosts = ghostMarks(grid);

	const std::size_t trimmed_before = counts.trimmed;
	if (!chooseTypes(types, lists, ghosts, counts, curved))
		return nullptr;
	json cells = {{"types", writer.write(NumberType::uint8, types.data(), types.size())}};
	if (curved)
	{
		cells["curved"] = true;
		writeShapeArrays(writer, grid, cells);
	}
	if (counts.trimmed > trimmed_before)
		writeTrimmed(writer, types, lists, cells);
	else
	{
		if (curved || !areAlike(types, lists))
			cells["offsets"] = arrays::writeInt64(writer, lists.offsets);
		cells["connectivity"] = arrays::writeIds(writer, lists.connectivity);
	}
	if (std::find(types.begin(), types.end(), read::kPolyhedron) != types.end())
		writeFaces(writer, types, grid, cells);
	return cells;
}

} // namespace

json writeCells(arrays::Writer& writer, vtkUnstructuredGrid* grid, CellCounts& counts, bool curved)
{
	vtkCellArray* cells = grid->GetCells();
	if (!cells || !grid->GetCellTypesArray() || grid->GetNumberOfCells() == 0)
		return nullptr;
	if (!grid->GetPoints())
		throw damaged("cells without points");
	if (cells->IsStorage64Bit())
		return writeCellsAs<std::int64_t>(writer, grid, counts, curved);
	return writeCellsAs<std::int32_t>(writer, grid, counts, curved);
}

vtkUnsignedCharArray* ghostMarks(vtkUnstructuredGrid* grid)
{
	auto* ghosts =
	    vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
	if (ghosts && ghosts->GetNumberOfValues() != grid->GetNumberOfCells())
		throw damaged("the ghost marks do not match the cells");
	return ghosts;
}

void refuseBadLists(vtkUnstructuredGrid* grid)
{
	vtkCellArray* cells = grid->GetCells();
	const auto count = static_cast<std::size_t>(grid->GetCellTypesArray()->GetNumberOfValues());
	if (cells->IsStorage64Bit())
		refuseBadOffsets(listsOf<std::int64_t>(cells), count);
	else
		refuseBadOffsets(listsOf<std::int32_t>(cells), count);
}

std::span<const vtkIdType> polyhedronFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
	if (!grid->GetFaces() || !grid->GetFaceLocations())
		throw damaged("polyhedra without faces");
	const auto faces = spanOf<vtkIdType>(grid->GetFaces());
	const auto locations = spanOf<vtkIdType>(grid->GetFaceLocations());
	if (locations.size() != static_cast<std::size_t>(grid->GetNumberOfCells()))
		throw damaged("the polyhedra's faces do not match the cells");
	const vtkIdType start = locations[static_cast<std::size_t>(cell)];
	if (start < 0 || start >= static_cast<vtkIdType>(faces.size()))
		throw damaged("cell " + std::to_string(cell) + " is a polyhedron without faces");
	const auto begin = static_cast<std::size_t>(start);
	std::size_t at = begin + 1;
	for (vtkIdType f = 0; f < faces[begin]; ++f)
	{
		const vtkIdType size = at < faces.size() ? faces[at] : -1;
		if (size < 0 || static_cast<std::size_t>(size) >= faces.size() - at)
			throw damaged("the faces of cell " + std::to_string(cell) + " run past their end");
		at += static_cast<std::size_t>(size) + 1;
	}
	return faces.subspan(begin, at - begin);
}

} // namespace vp::reader::cells
