#pragma once

#include "base/ids.h"
#include "grid/structured.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace vp::grid
{

struct Block;

// The cells of a block by their subscripts (i, j, k), hidden cells included.
class LatticeCells
{
public:
	explicit LatticeCells(const Lattice& lattice, std::span<const CellId> stored = {})
	    : lattice_(lattice), stored_(stored)
	{
	}
	explicit LatticeCells(const CurvilinearGrid& grid)
	    : lattice_(grid.sourceLattice()), turned_(grid), axes_(grid.axes())
	{
	}

	const Lattice& lattice() const { return lattice_; } // its cells and points have the numbers of the file
	// Returns the axis of a cell's points that runs along the given axis of the file.
	int axisInCells(int axis) const { return static_cast<int>(std::ranges::find(axes_, axis) - axes_.begin()); }
	// Returns kNoCell if the cell is hidden.
	CellId at(const std::array<std::uint32_t, 3>& index) const
	{
		if (turned_)
			return turned_->cell(index[axes_[0]], index[axes_[1]], index[axes_[2]]);
		const CellId cell = lattice_.cell(index[0], index[1], index[2]);
		return stored_.empty() ? cell : stored_[cell];
	}

private:
	Lattice lattice_;
	std::span<const CellId> stored_; // per cell of the lattice; empty: the numbers are the same
	std::optional<Lattice> turned_;  // as the grid stores it, if its axes have another order
	std::array<std::uint8_t, 3> axes_{0, 1, 2};
};

// The numbers of the cells of a lattice in a grid that leaves out hidden cells. They are found at the first use, in one
// pass over the cells.
class LazyCellPlaces
{
public:
	std::span<const CellId> of(const Block& block);
	std::size_t bytes() const { return stored_.capacity() * sizeof(CellId); } // while nobody fills it

private:
	std::once_flag filled_;
	std::vector<CellId> stored_;
};

// Returns nothing if the cells of the block have no subscripts. Thread safe. The block must outlive the result.
std::optional<LatticeCells> latticeCellsOf(const Block& block);

} // namespace vp::grid
