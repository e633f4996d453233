#pragma once

#include "grid/block.h"
#include "probe/transform.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace vp::bench
{

// A built-in data set, NAME:N. "layer:112 shuffled" has its cells in random order. "shell:256 jki" and "shell:256 kij"
// are the shell with its axes in another order as read.
const grid::BlockSet& gridNamed(const std::string& name);

// The same, cells listed as a file would list them: no neighbors built. Of this too the last is kept.
const grid::BlockSet& listedNamed(const std::string& name);
vtkDataSet* vtkListedNamed(const std::string& name);

// Returns the same grid as a VTK data set. Only the last grid and the last data set are kept, because several large
// ones do not fit into memory.
vtkDataSet* vtkNamed(const std::string& name);

// A grid as it comes from a file, nothing built: cells in the program's own order, or shuffled.
struct ReadCells
{
	grid::Points points;
	grid::CellList cells;
};
ReadCells readCells(const grid::UnstructuredGrid& grid, bool shuffled);

// The planes that `vprobe profile` sweeps through.
std::vector<probe::Frame> sweepOf(const Box& bounds);

} // namespace vp::bench
