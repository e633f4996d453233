#pragma once

#include "array_writer.h"

#include <nlohmann/json.hpp>

#include <map>

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
// arrays keep their numbering. Returns null, and writes nothing, if no cell is left.
nlohmann::json writeCells(ArrayWriter& writer, vtkUnstructuredGrid* grid, CellCounts& counts);
