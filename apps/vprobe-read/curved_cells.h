#pragma once

class vtkUnstructuredGrid;

// Whether a grid has curved cells, which a tolerance leaves as they are. Throws a Refusal where one of its cells is not
// refined to a tolerance, or lists another number of points than its type has.
bool keepsCurved(vtkUnstructuredGrid* grid, double tolerance);
