#include "seed/curved_seeds.h"

#include "locate/find_cell.h"
#include "seed/boundary_cut.h"
#include "seed/cut_cells.h"
#include "seed/nearest_cut.h"
#include "surface/leaf_values.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace vp::seed
{

namespace
{

// The leaves of a block's tree that the surface may pass through.
std::vector<std::uint32_t> leavesThatMeet(const grid::BlockTree& tree, const surface::BlockSurface& surface,
                                          const SheetWindow* window, std::size_t& tests)
{
	const surface::BlockValues* values = surface.values();
	const surface::LeafValues* known = values ? values->leaves.get() : nullptr;
	const auto meets = [&](const Box& box) { return surface.meets(box) && (!window || window->meets(box)); };
	std::vector<std::uint32_t> leaves;
	tests += tree.groups().size();
	for (std::size_t g = 0; g < tree.groups().size(); ++g)
	{
		const grid::BlockTree::Node& group = tree.groups()[g];
		if (!meets(group.box) || (known && !known->groupHolds(g, values->value)))
			continue;
		tests += group.end - group.begin;
		for (std::uint32_t leaf = group.begin; leaf < group.end; ++leaf)
			if (meets(tree.leaves()[leaf].box) && (!known || known->leafHolds(leaf, values->value)))
				leaves.push_back(leaf);
	}
	return leaves;
}

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

	// Whether the face of a cell towards lower numbers along an axis is cut.
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
	Index lo_{};                      // of the leaf
	Index size_{};                    // in cells
	Row signs_[kEdge + 1][kEdge + 1]; // of the points, by k and j
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

// One leaf after the other on all cores; seeds in the order of the leaves.
void seedTree(const grid::Block& block, const surface::BlockSurface& surface, const SheetWindow* window,
              const grid::CellFilter& filters, std::vector<CellId>& cells, std::size_t& tests)
{
	const grid::BlockTree& tree = grid::treeOf(block);
	const std::vector<std::uint32_t> leaves = leavesThatMeet(tree, surface, window, tests);
	constexpr std::size_t kLeaves = 16; // at a time
	struct Part
	{
		std::vector<CellId> seeds;
		std::size_t asked = 0;
	};
	std::vector<Part> parts((leaves.size() + kLeaves - 1) / kLeaves);
	const auto searchBy = [&](auto pieces, std::size_t p)
	{
		for (std::size_t i = p * kLeaves; i < std::min((p + 1) * kLeaves, leaves.size()); ++i)
		{
			const std::vector<CellId> seeds = pieces.seedsOf(tree, leaves[i]);
			parts[p].seeds.insert(parts[p].seeds.end(), seeds.begin(), seeds.end());
		}
		parts[p].asked = pieces.asked();
	};
	const auto search = [&](const auto& grid, std::size_t p)
	{
		if constexpr (std::is_base_of_v<grid::Lattice, std::decay_t<decltype(grid)>>)
			if (tree.inCubes() && !window)
				return searchBy(CubePieces(grid, surface, filters), p);
		searchBy(LeafPieces(grid, surface, window, filters), p);
	};
	std::visit([&](const auto& grid)
	           { tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t p) { search(grid, p); }); },
	           block.grid);
	for (const Part& part : parts)
	{
		cells.insert(cells.end(), part.seeds.begin(), part.seeds.end());
		tests += part.asked;
	}
}

// Faces that lie in the surface, and with `seeds_cut` the cells of those that are cut.
void seedBoundary(const grid::Block& block, const surface::BlockSurface& surface, const SheetWindow* window,
                  const grid::CellFilter& filters, bool seeds_cut, std::size_t b, SheetSeeds& seeds)
{
	const auto admitted = [&](CellId cell) { return !filters || filters(cell); };
	const auto search = [&](const auto& grid)
	{
		const auto addCut = [&](const CutFace& face)
		{
			if (seeds_cut && (seeds.cells[b].empty() || seeds.cells[b].back() != face.cell))
				seeds.cells[b].push_back(face.cell);
		};
		const auto addFlat = [&](const grid::BoundaryIndex::Face& face)
		{
			if (admitted(face.cell) && !isCut(grid, surface, face.cell))
				seeds.faces_in_plane[b].push_back(face);
		};
		seeds.boundary_tests += visitBoundaryCut(grid, block.boundary, surface, window, addCut, addFlat);
	};
	std::visit(search, block.grid);
}

// Where a line first meets the surface.
std::optional<Vec3> meetingOn(const surface::BlockSurface& surface, const Vec3& from, const Vec3& along)
{
	constexpr int kSteps = 256;
	const auto heightAt = [&](double t) { return *surface.heightAt(from + t * along); };
	double before = 0.0;
	const bool positive = heightAt(0.0) >= 0.0;
	for (int step = 1; step <= kSteps; ++step)
	{
		double after = static_cast<double>(step) / kSteps;
		if ((heightAt(after) >= 0.0) == positive)
		{
			before = after;
			continue;
		}
		for (double middle = 0.5 * (before + after); middle > before && middle < after; middle = 0.5 * (before + after))
			((heightAt(middle) >= 0.0) == positive ? before : after) = middle;
		return from + after * along;
	}
	return std::nullopt;
}

// The first hot spot along the sheet's axes that lies in the grid.
void seedAlongAxes(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                   const probe::Sheet& sheet, const SheetWindow* window, SheetSeeds& seeds)
{
	const double reach = blocks.bounds().diagonal();
	const Vec3 axes[] = {sheet.normal, -sheet.normal, sheet.up, -sheet.up, sheet.xAxis(), -sheet.xAxis()};
	for (const Vec3& axis : axes)
		for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		{
			if (!surfaces[b].heightAt(sheet.origin))
				return;
			const std::optional<Vec3> spot = meetingOn(surfaces[b], sheet.origin, reach * axis);
			if (!spot)
				break;
			const locate::Located located = locate::findCell(blocks.blocks[b], kNoCell, *spot);
			seeds.hops += located.hops;
			seeds.boundary_tests += located.boundary_tests;
			if (!located.found())
				continue;
			const CellId cell =
			    std::visit([&](const auto& grid) { return nearestCutCell(grid, surfaces[b], window, located.cell); },
			               blocks.blocks[b].grid);
			if (cell == kNoCell)
				continue;
			seeds.hot_spot_inside = true;
			seeds.cells[b].push_back(cell);
			return;
		}
}

} // namespace

SheetSeeds findSeeds(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                     const probe::Sheet& sheet, SeedMode mode, std::span<const grid::CellFilter> filters)
{
	SheetSeeds seeds;
	seeds.cells.resize(blocks.blocks.size());
	seeds.faces_in_plane.resize(blocks.blocks.size());
	seeds.rim.resize(blocks.blocks.size());
	const std::optional<SheetWindow> limits = sheet.window ? std::optional<SheetWindow>(sheet) : std::nullopt;
	const SheetWindow* window = limits ? &*limits : nullptr;
	if (mode == SeedMode::hotspot)
		seedAlongAxes(blocks, surfaces, sheet, window, seeds);
	for (std::size_t b = 0; b < blocks.blocks.size() && mode != SeedMode::hotspot; ++b)
	{
		const grid::Block& block = blocks.blocks[b];
		const grid::CellFilter admitted = filters.empty() ? grid::CellFilter() : filters[b];
		seedBoundary(block, surfaces[b], window, admitted, mode == SeedMode::boundary, b, seeds);
		if (mode == SeedMode::automatic)
			seedTree(block, surfaces[b], window, admitted, seeds.cells[b], seeds.tree_tests);
	}
	for (const std::vector<CellId>& cells : seeds.cells)
		seeds.count += cells.size();
	return seeds;
}

} // namespace vp::seed
