#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/grid.h"
#include "grid/structured.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace vp::grid
{

// Boxes around groups of cells. A leaf is a cube of 8^3 cells of a lattice, or a run of 512 cells of an unstructured
// grid (along its Morton curve) or of a list. A group is 64 leaves (4^3 cubes). The tree finds the cells that a surface
// may meet without a traversal. It gives the seeds of surfaces that touch no boundary, and it checks the traversal. It
// is built in one parallel pass over the cells, and takes 64 bytes for 512 cells and 4 bytes for each cell of a list.
class BlockTree
{
public:
	struct Node
	{
		Box box;             // around all points of its cells
		std::uint32_t begin; // leaf: its first cell (place in the list) or lowest lattice cell; group: its first leaf
		std::uint32_t end;   // run or group: one past the last
	};

	BlockTree() = default;
	// Builds the tree of all cells of one of the four grids of block.h.
	template <Grid G>
	explicit BlockTree(const G& grid);
	// Builds the tree of some cells.
	template <Grid G>
	BlockTree(const G& grid, std::span<const CellId> cells);

	// Calls visit(cell) once for every cell of the leaves whose box passes meets(box). These are all cells that meet
	// the surface, and some more. If meets() is true for a box, it must be true for every box around it. Returns the
	// number of boxes that were asked.
	template <class Meets, class Visit>
	std::size_t visitWhere(Meets&& meets, Visit&& visit) const
	{
		std::size_t tests = groups_.size();
		for (const Node& group : groups_)
		{
			if (!meets(group.box))
				continue;
			tests += group.end - group.begin;
			for (std::uint32_t leaf = group.begin; leaf < group.end; ++leaf)
				if (meets(leaves_[leaf].box))
					forEachCell(leaves_[leaf], visit);
		}
		return tests;
	}

	std::span<const Node> leaves() const { return leaves_; }
	std::span<const Node> groups() const { return groups_; }
	std::size_t bytes() const
	{
		return (leaves_.capacity() + groups_.capacity()) * sizeof(Node) + list_.capacity() * sizeof(CellId);
	}

	static constexpr std::uint32_t kLeafCells = 512;
	static constexpr std::uint32_t kLeafEdge = 8; // cells of a lattice
	static constexpr std::uint32_t kGroupLeaves = 64;
	static constexpr std::uint32_t kGroupEdge = 4; // leaves of a lattice

	// Calls visit(cell) for the cells of a leaf.
	template <class Visit>
	void forEachCell(const Node& leaf, Visit&& visit) const
	{
		if (in_cubes_)
			return forEachInCube(leaf, visit);
		for (std::uint32_t i = leaf.begin; i < leaf.end; ++i)
			visit(list_.empty() ? i : list_[i]);
	}

	// Returns true if leaves are cubes of lattice cells.
	bool inCubes() const { return in_cubes_; }
	// The lowest and the highest cell index of a leaf that is a cube, the latter one past the last.
	std::pair<std::array<std::uint32_t, 3>, std::array<std::uint32_t, 3>> cube(const Node& leaf) const
	{
		const std::array<std::uint32_t, 3> lo = lattice_.cellIndex(leaf.begin);
		std::array<std::uint32_t, 3> hi;
		for (int axis = 0; axis < 3; ++axis)
			hi[axis] = std::min(lo[axis] + kLeafEdge, lattice_.cells()[axis]);
		return {lo, hi};
	}

private:
	template <class Visit>
	void forEachInCube(const Node& leaf, Visit&& visit) const
	{
		const auto [lo, hi] = cube(leaf);
		for (std::uint32_t k = lo[2]; k < hi[2]; ++k)
			for (std::uint32_t j = lo[1]; j < hi[1]; ++j)
				for (std::uint32_t i = lo[0]; i < hi[0]; ++i)
					visit(lattice_.cell(i, j, k));
	}
	void addCubes();
	void addRuns(std::size_t cells);
	template <Grid G>
	void fillBoxes(const G& grid);

	bool in_cubes_ = false;
	Lattice lattice_;          // lattice of the cubes
	std::vector<CellId> list_; // cells of the runs; empty: all cells
	std::vector<Node> leaves_;
	std::vector<Node> groups_;
};

// A tree that is built at its first use.
class LazyBlockTree
{
public:
	template <Grid G>
	const BlockTree& over(const G& grid)
	{
		std::call_once(built_, [&] { tree_ = BlockTree(grid); });
		return tree_;
	}
	std::size_t bytes() const { return tree_.bytes(); } // while nobody builds it

private:
	std::once_flag built_;
	BlockTree tree_;
};

} // namespace vp::grid
