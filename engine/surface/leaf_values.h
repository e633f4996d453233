#pragma once

#include "grid/block.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace vp::surface
{

// The least and the greatest shown value of an array. There is a pair for each leaf of a block's tree over all cells,
// and for each group of leaves. Iso surfaces use them as other surfaces use boxes. They are made in one pass over all
// cells, on all cores, and take 8 bytes for a leaf of 512 cells.
class LeafValues
{
public:
	// field: a point array. component: 0.. or grid::kMagnitude.
	LeafValues(const grid::Block& block, const grid::Field& field, int component);

	// Return true if the values include this one, or lie on both sides of it.
	bool groupHolds(std::size_t group, double value) const { return holds(groups_[group], value); }
	bool leafHolds(std::size_t leaf, double value) const { return holds(leaves_[leaf], value); }
	// Returns true if all shown values are finite.
	bool allFinite() const { return all_finite_; }
	std::size_t bytes() const { return (leaves_.capacity() + groups_.capacity()) * sizeof(Span); }

private:
	using Span = std::pair<float, float>; // rounded outwards; of finite values
	static bool holds(const Span& span, double value) { return span.first <= value && value <= span.second; }

	std::vector<Span> leaves_;
	std::vector<Span> groups_;
	bool all_finite_ = true;
};

} // namespace vp::surface
