#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>
#include <vtkDataSetAttributes.h>
#include <vtkType.h>

#include <map>
#include <span>

class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

// Cells that are not handed over as they stand.
struct CellCounts
{
	std::size_t flat = 0;                           // of dimension below three
	std::size_t hidden = 0;                         // ghosts, refined and blanked cells
	std::size_t trimmed = 0;                        // that list more points than their type has
	std::map<std::uint8_t, std::size_t> not_sliced; // three-dimensional, of a type that cannot be sliced, by type
};

// Writes the cell lists of a grid. A cell that is not to be shown stays in the list as an empty cell, so that cell
// arrays keep their numbering. Returns null, and writes nothing, if no cell is left. curved: keepsCurved() is true.
nlohmann::json writeCells(ArrayWriter& writer, vtkUnstructuredGrid* grid, CellCounts& counts, bool curved = false);

// The marks of a grid's cells, null where it has none. Throws a Refusal where there are more or fewer than cells.
vtkUnsignedCharArray* ghostMarks(vtkUnstructuredGrid* grid);

// Throws a Refusal where the offsets do not rise or run past the connectivity.
void refuseBadLists(vtkUnstructuredGrid* grid);

// Of a polyhedron: faces, then per face its size and points. Throws a Refusal where they run past their end.
std::span<const vtkIdType> polyhedronFaces(vtkUnstructuredGrid* grid, vtkIdType cell);
