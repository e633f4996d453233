#pragma once

#include "base/vec.h"

#include <vtkType.h>

#include <cstdint>
#include <vector>

class vtkIdList;
class vtkUnstructuredGrid;

namespace vp::reader::cells
{

class SourceCells;
struct CellKind;

// Finds the order in which a file lists the nodes of its curved cells, and brings them into VTK's: its shape functions
// take the nodes, and their rational weights, from the grid.
class CellsInOrder
{
public:
	CellsInOrder(vtkUnstructuredGrid* grid, SourceCells& source) : grid_(grid), source_(source) {}

	// Adds a cell that `source` has entered. Its points must exist.
	void add(vtkIdType cell, std::uint8_t type, CellKind& kind, vtkIdList* points);

	// Changes the lists of those added cells that have another order.
	void apply();

private:
	struct Doubtful
	{
		vtkIdType cell;
		std::uint8_t type;
	};

	vtkUnstructuredGrid* grid_;
	SourceCells& source_;
	std::vector<Doubtful> doubtful_;
	std::vector<Vec3> nodes_;
};

} // namespace vp::reader::cells
