#pragma once

#include "base/ids.h"
#include "grid/block_tree.h"
#include "grid/cell_filter.h"
#include "grid/grid.h"
#include "seed/cut_cells.h"
#include "seed/sheet_window.h"
#include "surface/curved.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::seed
{

// The pieces of a surface within a leaf that is a cube of lattice cells. The heights of its points are asked once each,
// and all else is done with their signs, a bit each in rows along i.
template <class G>
class CubePieces
{
public:
	CubePieces(const G& grid, const surface::BlockSurface& surface, const grid::CellFilter& filter)
	    : grid_(grid), surface_(surface), filter_(filter)
	{
	}

	// Returns a cell of each piece: the one with the lowest number, in the order of the numbers.
	std::vector<CellId> seedsOf(const grid::BlockTree& tree, std::uint32_t leaf)
	{
		const auto [lo, hi] = tree.cube(tree.leaves()[leaf]);
		lo_ = lo;
		for (int axis = 0; axis < 3; ++axis)
			size_[axis] = hi[axis] - lo[axis];
		asked_ += std::size_t(size_[0]) * size_[1] * size_[2];
		takeSigns();
		std::vector<CellId> seeds;
		if (!takeCells())
			return seeds;
		for (std::uint32_t k = 0; k < size_[2]; ++k)
			for (std::uint32_t j = 0; j < size_[1]; ++j)
				while (const Row row = left_[k][j])
				{
					const auto i = static_cast<std::uint32_t>(std::countr_zero(row));
					seeds.push_back(cellAt({i, j, k}));
					flood({i, j, k});
				}
		return seeds;
	}
	std::size_t asked() const { return asked_; } // cells

private:
	using Row = std::uint32_t;
	using Index = std::array<std::uint32_t, 3>;
	static constexpr std::uint32_t kEdge = grid::BlockTree::kLeafEdge;

	CellId cellAt(const Index& at) const { return grid_.cell(lo_[0] + at[0], lo_[1] + at[1], lo_[2] + at[2]); }

	void takeSigns()
	{
		std::array<PointId, kEdge + 1> points;
		std::array<double, kEdge + 1> heights;
		if constexpr (requires { grid_.prefetch(PointId{}, PointId{}); })
			for (std::uint32_t k = 0; k <= size_[2]; ++k)
				for (std::uint32_t j = 0; j <= size_[1]; ++j)
				{
					const PointId row = grid_.pointId(lo_[0], lo_[1] + j, lo_[2] + k);
					grid_.prefetch(row, row + size_[0]);
				}
		for (std::uint32_t k = 0; k <= size_[2]; ++k)
			for (std::uint32_t j = 0; j <= size_[1]; ++j)
			{
				for (std::uint32_t i = 0; i <= size_[0]; ++i)
					points[i] = grid_.pointId(lo_[0] + i, lo_[1] + j, lo_[2] + k);
				surface_.heights(grid_, std::span(points).first(size_[0] + 1), heights.data());
				Row row = 0;
				for (std::uint32_t i = 0; i <= size_[0]; ++i)
					row |= Row(heights[i] >= 0.0) << i;
				signs_[k][j] = row;
			}
	}

	// Bit i: whether the points i and i + 1 of the rows have different signs.
	static Row mixed(Row any, Row all) { return (any | any >> 1) & ~(all & all >> 1); }

	// Takes the cells that are cut. Returns false if there are none.
	bool takeCells()
	{
		const Row every = (Row(1) << size_[0]) - 1;
		Row some = 0;
		for (std::uint32_t k = 0; k < size_[2]; ++k)
			for (std::uint32_t j = 0; j < size_[1]; ++j)
			{
				const Row a = signs_[k][j], b = signs_[k][j + 1], c = signs_[k + 1][j], d = signs_[k + 1][j + 1];
				Row cut = mixed(a | b | c | d, a & b & c & d) & every;
				if (filter_)
					for (Row cells = cut; cells; cells &= cells - 1)
						if (const auto i = static_cast<std::uint32_t>(std::countr_zero(cells));
						    !filter_(cellAt({i, j, k})))
							cut &= ~(Row(1) << i);
				left_[k][j] = cut;
				some |= cut;
			}
		return some != 0;
	}

	// Returns true if the face of a cell towards lower numbers along an axis is cut.
	bool isFaceCut(const Index& at, int axis) const
	{
		const auto [i, j, k] = at;
		const Row a = signs_[k][j];
		if (axis == 0)
		{
			const Row b = signs_[k][j + 1], c = signs_[k + 1][j], d = signs_[k + 1][j + 1];
			return ((a | b | c | d) & ~(a & b & c & d)) >> i & 1;
		}
		const Row b = axis == 1 ? signs_[k + 1][j] : signs_[k][j + 1];
		return mixed(a | b, a & b) >> i & 1;
	}

	void flood(const Index& first)
	{
		queue_.clear();
		enter(first);
		while (!queue_.empty())
		{
			const Index at = queue_.back();
			queue_.pop_back();
			for (int axis = 0; axis < 3; ++axis)
			{
				Index next = at;
				if (at[axis] > 0 && isFaceCut(at, axis))
				{
					--next[axis];
					enter(next);
				}
				next = at;
				++next[axis];
				if (next[axis] < size_[axis] && isFaceCut(next, axis))
					enter(next);
			}
		}
	}
	void enter(const Index& at)
	{
		Row& row = left_[at[2]][at[1]];
		if (!(row >> at[0] & 1))
			return;
		row &= ~(Row(1) << at[0]);
		queue_.push_back(at);
	}

	const G& grid_;
	const surface::BlockSurface& surface_;
	const grid::CellFilter& filter_;
	Index lo_{};                      // first cell of the leaf
	Index size_{};                    // size in cells
	Row signs_[kEdge + 1][kEdge + 1]; // signs of the points, by k and j
	Row left_[kEdge][kEdge];          // cut cells that no piece has yet, by k and j
	std::vector<Index> queue_;
	std::size_t asked_ = 0;
};

// The pieces of a surface within any leaf.
template <grid::Grid G>
class LeafPieces
{
public:
	LeafPieces(const G& grid, const surface::BlockSurface& surface, const SheetWindow* window,
	           const grid::CellFilter& filters)
	    : grid_(grid), surface_(surface), window_(window), filter_(filters)
	{
	}

	// Returns a cell of each piece, as CubePieces does.
	std::vector<CellId> seedsOf(const grid::BlockTree& tree, std::uint32_t leaf)
	{
		cells_.clear();
		tree.forEachCell(tree.leaves()[leaf],
		                 [&](CellId cell)
		                 {
			                 ++asked_;
			                 if (isCut(grid_, surface_, cell) && (!filter_ || filter_(cell)) && isInWindow(cell))
				                 cells_.push_back(cell);
		                 });
		std::ranges::sort(cells_);
		met_.assign(cells_.size(), false);
		std::vector<CellId> seeds;
		for (std::size_t i = 0; i < cells_.size(); ++i)
			if (!met_[i])
			{
				seeds.push_back(cells_[i]);
				flood(i);
			}
		return seeds;
	}
	std::size_t asked() const { return asked_; } // cells

private:
	bool isInWindow(CellId cell)
	{
		if (!window_)
			return true;
		grid_.cellFaces(cell, faces_);
		return window_->meetsCell(grid_, surface_, faces_);
	}

	void flood(std::size_t first)
	{
		queue_.assign(1, first);
		met_[first] = true;
		while (!queue_.empty())
		{
			const CellId cell = cells_[queue_.back()];
			queue_.pop_back();
			grid_.cellFaces(cell, faces_);
			for (int f = 0; f < faces_.size(); ++f)
				if (isFaceCut(grid_, surface_, faces_[f]) &&
				    (!window_ || window_->meetsFace(grid_, surface_, faces_[f])))
					grid_.forEachNeighbor(cell, f, [&](CellId neighbor) { enter(neighbor); });
		}
	}
	void enter(CellId cell)
	{
		const auto at = std::ranges::lower_bound(cells_, cell);
		const auto place = static_cast<std::size_t>(at - cells_.begin());
		if (at == cells_.end() || *at != cell || met_[place])
			return;
		met_[place] = true;
		queue_.push_back(place);
	}

	const G& grid_;
	const surface::BlockSurface& surface_;
	const SheetWindow* window_;
	const grid::CellFilter& filter_;
	std::vector<CellId> cells_; // that are cut, ascending
	std::vector<bool> met_;
	std::vector<std::size_t> queue_;
	grid::CellFaces faces_;
	std::size_t asked_ = 0;
};

} // namespace vp::seed
