#pragma once

#include "cf_volumes.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataSet;

namespace vp::reader::volumes
{

struct CfGrid
{
	vtkSmartPointer<vtkDataSet> data;
	bool has_cell_values = false; // the values are of cells, whose corners the file gives
	std::string length_units;     // the unit of all axes, if they have one
	std::vector<std::string> notes;
};

// The values of a variable over the axes x and y at a step, rows along x. `corners`: how many it has for each place.
std::vector<double> cfPlane(const hdf5::NetcdfFile& file, const CfVolumes& volumes, int variable, std::size_t step,
                            std::size_t corners);

// The grid of a file's volumes at a step of its times. Places that are missing are NaN.
CfGrid cfGrid(const hdf5::NetcdfFile& file, const CfVolumes& volumes, std::size_t step);

// A longitude that jumps by more than half a turn goes on beyond 180 or 360 instead. `width`: how many lie in a row;
// each has neighbors before and after it in its row, and in the rows beside. False for those that have a neighbor more
// than half a turn away even so, as around a pole.
std::vector<bool> unwrapLongitudes(std::vector<double>& places, std::size_t width);

} // namespace vp::reader::volumes
