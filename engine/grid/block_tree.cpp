#include "grid/block_tree.h"

#include "base/parallel_for.h"
#include "grid/unstructured.h"

#include <tbb/blocked_range.h>

#include <type_traits>

namespace vp::grid
{

namespace
{

template <Grid G>
void includeCell(const G& grid, CellId cell, CellFaces& faces, Box& box)
{
	const auto include = [&](PointId p) { box.include(grid.point(p)); };
	if (grid.shape(cell) == CellShape::polyhedron)
	{
		grid.cellFaces(cell, faces);
		std::ranges::for_each(faces.points, include);
		return;
	}
	for (const PointId p : grid.cellPoints(cell))
		include(p);
}

// The points of the cells from lo to hi, each once.
template <class G>
Box boxOfCube(const G& grid, const std::array<std::uint32_t, 3>& lo, const std::array<std::uint32_t, 3>& hi)
{
	Box box;
	for (std::uint32_t k = lo[2]; k <= hi[2]; ++k)
		for (std::uint32_t j = lo[1]; j <= hi[1]; ++j)
		{
			const PointId row = grid.pointId(0, j, k);
			for (std::uint32_t i = lo[0]; i <= hi[0]; ++i)
				box.include(grid.point(row + i));
		}
	return box;
}

} // namespace

template <Grid G>
BlockTree::BlockTree(const G& grid)
{
	if constexpr (std::is_base_of_v<Lattice, G>)
	{
		in_cubes_ = true;
		lattice_ = grid;
		addCubes();
	}
	else
		addRuns(grid.cellCount());
	fillBoxes(grid);
}

template <Grid G>
BlockTree::BlockTree(const G& grid, std::span<const CellId> cells) : list_(cells.begin(), cells.end())
{
	addRuns(cells.size());
	fillBoxes(grid);
}

// Group by group, leaf by leaf.
void BlockTree::addCubes()
{
	constexpr std::uint32_t group_cells = kLeafEdge * kGroupEdge;
	const auto forBoxes = [](const std::array<std::uint32_t, 3>& lo, const std::array<std::uint32_t, 3>& hi,
	                         std::uint32_t step, auto&& visit)
	{
		for (std::uint32_t k = lo[2]; k < hi[2]; k += step)
			for (std::uint32_t j = lo[1]; j < hi[1]; j += step)
				for (std::uint32_t i = lo[0]; i < hi[0]; i += step)
					visit(std::array<std::uint32_t, 3>{i, j, k});
	};
	forBoxes({0, 0, 0}, lattice_.cells(), group_cells,
	         [&](const std::array<std::uint32_t, 3>& lo)
	         {
		         const auto begin = static_cast<std::uint32_t>(leaves_.size());
		         std::array<std::uint32_t, 3> hi;
		         for (int axis = 0; axis < 3; ++axis)
			         hi[axis] = std::min(lo[axis] + group_cells, lattice_.cells()[axis]);
		         forBoxes(lo, hi, kLeafEdge,
		                  [&](const std::array<std::uint32_t, 3>& at)
		                  {
			                  const CellId first = lattice_.cell(at[0], at[1], at[2]);
			                  leaves_.push_back({Box{}, first, first});
		                  });
		         groups_.push_back({Box{}, begin, static_cast<std::uint32_t>(leaves_.size())});
	         });
}

void BlockTree::addRuns(std::size_t cells)
{
	const auto cut = [](std::size_t size, std::uint32_t step, std::vector<Node>& nodes)
	{
		for (std::size_t begin = 0; begin < size; begin += step)
			nodes.push_back({Box{}, static_cast<std::uint32_t>(begin),
			                 static_cast<std::uint32_t>(std::min<std::size_t>(begin + step, size))});
	};
	cut(cells, kLeafCells, leaves_);
	cut(leaves_.size(), kGroupLeaves, groups_);
}

template <Grid G>
void BlockTree::fillBoxes(const G& grid)
{
	const auto fill = [&](Node& leaf, CellFaces& faces)
	{
		if constexpr (std::is_base_of_v<Lattice, G>)
			if (in_cubes_)
			{
				const auto [lo, hi] = cube(leaf);
				leaf.box = boxOfCube(grid, lo, hi);
				return;
			}
		forEachCell(leaf, [&](CellId cell) { includeCell(grid, cell, faces, leaf.box); });
	};
	parallelFor(tbb::blocked_range<std::size_t>(0, leaves_.size(), 8),
	            [&](const auto& range)
	            {
		            CellFaces faces;
		            for (std::size_t leaf = range.begin(); leaf < range.end(); ++leaf)
			            fill(leaves_[leaf], faces);
	            });
	for (Node& group : groups_)
		for (std::uint32_t leaf = group.begin; leaf < group.end; ++leaf)
			group.box.include(leaves_[leaf].box);
}

template BlockTree::BlockTree(const UniformGrid&);
template BlockTree::BlockTree(const RectilinearGrid&);
template BlockTree::BlockTree(const CurvilinearGrid&);
template BlockTree::BlockTree(const UnstructuredGrid&);
template BlockTree::BlockTree(const UniformGrid&, std::span<const CellId>);
template BlockTree::BlockTree(const RectilinearGrid&, std::span<const CellId>);
template BlockTree::BlockTree(const CurvilinearGrid&, std::span<const CellId>);
template BlockTree::BlockTree(const UnstructuredGrid&, std::span<const CellId>);

} // namespace vp::grid
