#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json_fwd.hpp>

class vtkUnstructuredGrid;

namespace vp::reader::cells
{

// Returns true if a grid has curved cells, and a tolerance keeps them curved. Brings their nodes into VTK's order, and
// makes smaller cells of those that have collapsed. Throws a Refusal if a cell cannot be refined to a tolerance, or
// lists fewer points than its type has.
bool keepsCurved(vtkUnstructuredGrid* grid, double tolerance);

// Adds the degrees of the cells and the rational weights of the points to lists of curved cells, if the grid has them.
void writeShapeArrays(arrays::Writer& writer, vtkUnstructuredGrid* grid, nlohmann::json& cells);

} // namespace vp::reader::cells
