#pragma once

#include "base/result.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace vp::surface
{

// A grid surface, the "IJK" of CFD that Speray and Kennon compare slicing with: all places of structured blocks with
// one fixed subscript. The subscript counts points from 0. With a fraction the surface lies between two such surfaces,
// along the edges of the cells there.
struct GridIndex
{
	int axis = 0;       // 0, 1, 2: i, j, k
	double index = 0.0; // 0 to the number of cells along the axis

	bool operator==(const GridIndex&) const = default;
};

// The layers of cells along the axis of a block that show a grid surface.
struct GridLayers
{
	std::uint32_t cell;          // the layer it lies in; between two layers the lower one, at index 0 the one above
	bool has_other_side = false; // it lies between this layer and the next
};

// cells: number along the axis, at least 1. The index must be 0 to `cells`.
GridLayers layersOf(double index, std::uint32_t cells);

// Returns the place of the surface along the edges of a layer that shows it: 0 to 1.
inline double placeIn(std::uint32_t layer, double index)
{
	return std::clamp(index - layer, 0.0, 1.0);
}

// A range from one surface to another, for sweeps.
struct GridIndexRange
{
	int axis = 0;
	double first = 0.0;
	double last = 0.0; // may be below `first`

	bool isOne() const { return first == last; }
	std::string text() const; // as parseGridIndex() takes it
	GridIndex at(double done) const { return {axis, done == 1.0 ? last : first + done * (last - first)}; } // 0 to 1

	bool operator==(const GridIndexRange&) const = default;
};

char axisName(int axis);                 // 'i', 'j', 'k'
std::string nameOf(const GridIndex& at); // "i=12.5"

// Reads "i=12.5", or "i=2..30" for a range. A usage error says what is wrong, without the name of the option. Numbers
// are finite but may lie outside any grid.
Result<GridIndexRange> parseGridIndex(const std::string& text);

} // namespace vp::surface
