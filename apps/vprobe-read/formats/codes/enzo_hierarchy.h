#pragma once

#include "vprobe-read/boxes/amr_cover.h"
#include "vprobe-read/boxes/cell_boxes.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

struct EnzoGrid
{
	std::size_t number; // from 1
	boxes::CellBox box;
	std::string file;
};

// Holds the facts in the text that lists the boxes of Enzo.
struct EnzoHierarchy
{
	std::vector<EnzoGrid> grids;
	double time;
};

EnzoHierarchy parseEnzoHierarchy(std::string_view text);

// The grids by their levels, from the coarsest; the number of a box is its place in the list of grids.
boxes::AmrLevels enzoLevels(const EnzoHierarchy& hierarchy);

// The factors that bring the values of variables to CGS units: from the file of parameters, which has the
// hierarchy's name without its ending. Empty where that says nothing.
std::map<std::string, double> enzoFactors(const std::string& hierarchy);

} // namespace vp::reader::codes
