#pragma once

#include "base/ids.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "grid/field_choice.h"

namespace vp::find
{

// A range of values outside which a traversal ends: the paper's "threshold value in the data".
struct Threshold
{
	double lo;
	double hi; // >= lo

	bool operator==(const Threshold&) const = default;
};

// Whether a cell has a part in the range: its values do not all lie below lo, nor all above hi. NaN is left out; a
// block without the array, or a cell that is NaN throughout, has no part. The block must outlive the filter.
grid::CellFilter cellsWithin(const grid::Block& block, const grid::FieldChoice& choice, const Threshold& threshold);

} // namespace vp::find
