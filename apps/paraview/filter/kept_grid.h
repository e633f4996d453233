#pragma once

#include "wrap_lattice.h"

#include <optional>
#include <stop_token>

namespace vprobe_paraview
{

// The library's data set of the input, which is kept until the input's points, cells or ghost marks change. Other
// arrays take the place of those before, and cost no more than a cut.
class KeptGrid
{
public:
	struct Counts
	{
		int grids = 0;     // that were taken
		int neighbors = 0; // how often neighbors of cells were built
		int cuts = 0;
	};

	// Makes it the data set of these leaves; throws Refused. Without leaves there is none.
	void take(const std::vector<Leaf>& leaves, double tolerance, std::stop_token stop);
	vprobe::Result<vprobe::Cut> cut(const vprobe::View& view, std::stop_token stop);

	const vprobe::Dataset* data() const { return data_ ? &*data_ : nullptr; }
	const std::vector<std::uint32_t>& leafOfBlock() const { return leaf_of_block_; }
	// The cell of the leaf that a cell of a block is.
	std::int64_t sourceCell(std::size_t block, std::int64_t cell) const
	{
		return crops_[block] ? crops_[block]->sourceCell(cell) : cell;
	}
	const Counts& counts() const { return counts_; }
	void forget();

private:
	void wrap(const std::vector<Leaf>& leaves, double tolerance, std::stop_token stop);
	void setFields(const std::vector<Leaf>& leaves);

	std::optional<vprobe::Dataset> data_;
	Stamps grid_stamps_;
	Stamps field_stamps_;
	std::vector<std::uint32_t> leaf_of_block_; // flat indices
	std::vector<std::optional<Crop>> crops_;   // of the blocks
	bool has_neighbors_ = false;
	Counts counts_;
};

} // namespace vprobe_paraview
