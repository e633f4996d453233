#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "vectors/traces.h"

#include <vector>

namespace vp::vectors
{

// Returns the values of an array at the points of traces, interpolated in their cells. A categorical array has the
// value of the nearest point. component kMagnitude: the length of the interpolated tuple. NaN if a block lacks the
// array.
std::vector<double> valuesAt(const grid::BlockSet& blocks, const grid::FieldChoice& field, const Traces& traces);

// Returns for each point the angle by which the field has turned its contents about the trace since the launch, in
// radians, right-handed about the direction of motion. It is half of the curl's part along the vector, integrated over
// time (the definition of stream ribbons by Darmofal and Haimes, 1992). vectors: the array of the traces. Arrays of
// cells turn nothing.
std::vector<double> turnsAlong(const grid::BlockSet& blocks, const grid::FieldChoice& vectors, const Traces& traces);

} // namespace vp::vectors
