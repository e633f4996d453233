#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "vectors/traces.h"

#include <span>
#include <vector>

namespace vp::vectors
{

// Returns the values of an array at the points of traces, interpolated in their cells. A categorical array has the
// value of the nearest point. component kMagnitude: the length of the interpolated tuple. NaN if a block lacks the
// array, or has no cells here.
std::vector<double> valuesAt(const grid::BlockSet& blocks, const grid::FieldChoice& field, const Traces& traces);

// Returns for each point how fast the field turns its contents about the trace, in radians a unit of time,
// right-handed about the direction of motion. It is half of the curl's part along the vector. vectors: the array of the
// traces. Arrays of cells turn nothing. 0 where a block has no cells here.
std::vector<double> turnRates(const grid::BlockSet& blocks, const grid::FieldChoice& vectors, const Traces& traces);

// Returns for each point the angle by which the field has turned its contents since the launch: the rates over time
// (the definition of stream ribbons by Darmofal and Haimes, 1992).
std::vector<double> turnsAlong(std::span<const double> rates, const Traces& traces);

} // namespace vp::vectors
