#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json_fwd.hpp>

class vtkUnstructuredGrid;

// Whether a grid has curved cells, which a tolerance leaves as they are. Brings their nodes into VTK's order, and makes
// smaller cells of those that have collapsed. Throws a Refusal where one of its cells is not refined to a tolerance, or
// lists fewer points than its type has.
bool keepsCurved(vtkUnstructuredGrid* grid, double tolerance);

// Adds the degrees of the cells and the rational weights of the points to lists of curved cells, where the grid has
// them.
void writeShapeArrays(ArrayWriter& writer, vtkUnstructuredGrid* grid, nlohmann::json& cells);
