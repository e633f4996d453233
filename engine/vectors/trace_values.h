#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "vectors/traces.h"

#include <vector>

namespace vp::vectors
{

// An array's values at the points of traces, interpolated in the cells that hold them; of categories the nearest
// point's. component kMagnitude: the length of the interpolated tuple. NaN where a block lacks the array.
std::vector<double> valuesAt(const grid::BlockSet& blocks, const grid::FieldChoice& field, const Traces& traces);

// How far the field turns what it carries about the traces, in radians from their launches on, right-handed about the
// way they go, per point: half of the curl's part along the vector, over time (as stream ribbons are defined by
// Darmofal and Haimes, 1992). vectors: the array of the traces. Arrays of cells turn nothing.
std::vector<double> turnsAlong(const grid::BlockSet& blocks, const grid::FieldChoice& vectors, const Traces& traces);

} // namespace vp::vectors
