#pragma once

#include "convert.h"

#include <vtkSmartPointer.h>

#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace vp::reader::convert
{

// The values of a grid that stands still, at each of its times.
class PackTimes
{
public:
	PackTimes(vtkUnstructuredGrid* kept, const TimesToPack& times) : kept_(kept), given_(times) {}

	bool areSeveral() const { return given_.times.size() > 1; }
	std::size_t count() const { return areSeveral() ? given_.times.size() : 1; }
	const std::vector<double>& times() const { return given_.times; }
	std::size_t kept() const { return given_.kept; } // the one whose grid it is
	// Returns it as a sentence has it.
	std::string nameOf(std::size_t time) const;

	// Takes the grid at a time out of the data sets that were read there. Throws a Refusal if none of them has its
	// points and cells.
	vtkSmartPointer<vtkUnstructuredGrid> takeGrid(std::size_t time, TimesToPack::Read& read) const;
	// Returns the values of an array at a time. grid: takeGrid() of it. kept: the array of the grid that was kept.
	// Throws a Refusal if the array is missing there, or has other numbers.
	vtkDataArray* valuesAt(std::size_t time, vtkUnstructuredGrid* grid, vtkDataArray* kept, bool on_points) const;

private:
	vtkUnstructuredGrid* kept_;
	const TimesToPack& given_;
};

} // namespace vp::reader::convert
