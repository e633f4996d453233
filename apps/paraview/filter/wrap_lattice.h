#pragma once

#include "wrap_data.h"

#include <array>

namespace vprobe_paraview
{

// A box of a lattice: all cells in it are shown, and none outside. Pieces with layers of ghost cells have one.
struct Crop
{
	std::array<std::size_t, 3> whole{};  // points of the lattice
	std::array<std::size_t, 3> low{};    // the first point of the box
	std::array<std::size_t, 3> points{}; // of the box

	// What lies in the box, copied.
	vprobe::Numbers ofPoints(const vprobe::Numbers& numbers, std::size_t components) const;
	vprobe::Numbers ofCells(const vprobe::Numbers& numbers, std::size_t components) const;
	// The cell of the lattice that a cell of the box is.
	std::int64_t sourceCell(std::int64_t cell) const;
};

// Nothing where all cells are shown, where others are hidden, and for data sets that are no lattice.
std::optional<Crop> cropOf(vtkDataSet& data);

// The grid of an image, a rectilinear or a structured grid. Nothing for other data sets; throws Refused.
std::optional<decltype(vprobe::Block::grid)> latticeOf(vtkDataSet& data);
// The points along i, j and k; false where it is no lattice.
bool dimensionsOf(vtkDataSet& data, int* lattice);
void addLatticeStamps(vtkDataSet& data, Stamps& stamps);

} // namespace vprobe_paraview
