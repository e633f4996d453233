#pragma once

#include "session/frame.h"

#include <cstddef>

namespace vp::app
{

// Holds the cost of a cut, for one sheet or several.
struct CutFigures
{
	std::size_t cut_cells = 0;
	std::size_t touched = 0;     // cells queued or given a polygon
	std::size_t generations = 0; // 0 if all cells were found at once
	std::size_t front_max = 0;
	std::size_t polygons = 0;
};

CutFigures figuresOf(const session::Frame& cut, std::size_t sheet);
CutFigures figuresOf(const session::Frame& cut); // sums over the sheets; for generations and fronts, the largest

} // namespace vp::app
