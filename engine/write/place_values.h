#pragma once

#include "grid/field.h"
#include "grid/grid.h"
#include "locate/interpolate.h"

#include <algorithm>

namespace vp::write
{

// Returns a component of a point array at a place, from the weights of the cell's points. For a categorical array it is
// the value of the point with the largest weight.
template <grid::Grid G>
double valueAt(const G& grid, const grid::Field& field, int component, const locate::CellWeights& place)
{
	if (field.categorical)
	{
		const auto nearest = std::ranges::max_element(place.weights) - place.weights.begin();
		return field.value(grid.sourcePoint(place.points[nearest]), component);
	}
	double value = 0.0;
	for (std::size_t i = 0; i < place.points.size(); ++i)
		if (place.weights[i] != 0.0) // a NaN there does not reach here
			value += place.weights[i] * field.value(grid.sourcePoint(place.points[i]), component);
	return value;
}

} // namespace vp::write
