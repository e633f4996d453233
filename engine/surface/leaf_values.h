#pragma once

#include "grid/block.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace vp::surface
{

// The least and the greatest of an array's shown values in each leaf of a block's tree over all cells, and in each
// group of leaves: what boxes are to surfaces with a place. One pass over all cells, on all cores; 8 bytes a leaf of
// 512.
class LeafValues
{
public:
	// field: of points. component: 0.. or grid::kMagnitude.
	LeafValues(const grid::Block& block, const grid::Field& field, int component);

	// Whether values on both sides of this one, or it, are there.
	bool groupHolds(std::size_t group, double value) const { return holds(groups_[group], value); }
	bool leafHolds(std::size_t leaf, double value) const { return holds(leaves_[leaf], value); }
	// Whether no shown value is NaN or infinite.
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
