#pragma once

#include "base/ids.h"
#include "grid/structured.h"

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace vp::grid
{

struct Block;

// The cells of a block by their subscripts (i, j, k), hidden ones too.
class LatticeCells
{
public:
	explicit LatticeCells(const Lattice& lattice, std::span<const CellId> stored = {})
	    : lattice_(lattice), stored_(stored)
	{
	}

	const Lattice& lattice() const { return lattice_; } // its cells and points have the numbers of the file
	// kNoCell where the cell is hidden.
	CellId at(const std::array<std::uint32_t, 3>& index) const
	{
		const CellId cell = lattice_.cell(index[0], index[1], index[2]);
		return stored_.empty() ? cell : stored_[cell];
	}

private:
	Lattice lattice_;
	std::span<const CellId> stored_; // per cell of the lattice; empty: each is its own
};

// Where the cells of a lattice are in a grid that leaves the hidden ones out; filled when it is first wanted, in one
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

// None where a block's cells have no subscripts. Thread safe; the block must outlive what it gives.
std::optional<LatticeCells> latticeCellsOf(const Block& block);

} // namespace vp::grid
