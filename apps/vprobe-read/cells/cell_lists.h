#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>
#include <vtkDataSetAttributes.h>
#include <vtkType.h>

#include <map>
#include <span>

class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace vp::reader::cells
{

// Counts the cells that are not handed over unchanged.
struct CellCounts
{
	std::size_t flat = 0;                           // cells of dimension below three
	std::size_t hidden = 0;                         // ghosts, refined and blanked cells
	std::size_t trimmed = 0;                        // that list more points than their type has
	std::map<std::uint8_t, std::size_t> not_sliced; // three-dimensional, of a type that cannot be sliced, by type
};

// Writes the cell lists of a grid. A cell that is not to be shown stays in the list as an empty cell, so that cell
// arrays keep their numbering. Returns null, and writes nothing, if no cell is left. curved: keepsCurved() is true.
nlohmann::json writeCells(arrays::Writer& writer, vtkUnstructuredGrid* grid, CellCounts& counts, bool curved = false);

// Returns the marks of a grid's cells, or null if it has none. Throws a Refusal if there is not one mark per cell.
vtkUnsignedCharArray* ghostMarks(vtkUnstructuredGrid* grid);

// Throws a Refusal if the offsets do not rise, or run past the connectivity.
void refuseBadLists(vtkUnstructuredGrid* grid);

// Returns the faces of a polyhedron: their number, then for each face its size and points. Throws a Refusal if they run
// past their end.
std::span<const vtkIdType> polyhedronFaces(vtkUnstructuredGrid* grid, vtkIdType cell);

} // namespace vp::reader::cells
