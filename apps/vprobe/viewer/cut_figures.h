#pragma once

#include "session/cut_frame.h"

#include <cstddef>

namespace vp::app
{

// What a cut took, of a sheet or of several.
struct CutFigures
{
	std::size_t cut_cells = 0;
	std::size_t touched = 0;     // cells queued or given a polygon
	std::size_t generations = 0; // 0 where all cells were found at once
	std::size_t front_max = 0;
	std::size_t polygons = 0;
};

CutFigures figuresOf(const session::CutFrame& cut, std::size_t sheet);
CutFigures figuresOf(const session::CutFrame& cut); // sums, and the largest of generations and fronts

} // namespace vp::app
