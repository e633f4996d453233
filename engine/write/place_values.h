#pragma once

#include "grid/field.h"
#include "grid/grid.h"
#include "locate/interpolate.h"

#include <algorithm>

namespace vp::write
{

// A component of a point array where a cell's points weigh so much; of a categorical one what the heaviest has.
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
