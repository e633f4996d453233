#include "seed/curved_seeds.h"

#include "base/parallel_for.h"
#include "locate/find_cell.h"
#include "seed/boundary_cut.h"
#include "seed/cut_cells.h"
#include "seed/leaf_pieces.h"
#include "seed/nearest_cut.h"
#include "surface/leaf_values.h"

#include <algorithm>
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
	           { tracedFor(std::size_t(0), parts.size(), [&](std::size_t p) { search(grid, p); }); },
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
		const auto addCut = [&](const grid::BoundaryIndex::Face& face)
		{
			if (seeds_cut && (seeds.cells[b].empty() || seeds.cells[b].back() != face.cell))
				seeds.cells[b].push_back(face.cell);
		};
		const auto addFlat = [&](const grid::BoundaryIndex::Face& face)
		{
			if (admitted(face.cell) && !isCut(grid, surface, face.cell))
				seeds.faces_in_plane[b].push_back(face);
		};
		seeds.boundary_tests += visitBoundaryCut(grid, block.boundary, block.bounds, surface, window, addCut, addFlat);
	};
	std::visit(search, block.grid);
}

// Returns where a line first meets the surface.
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
	for (int number = 0; number < 6; ++number)
		for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		{
			if (!surfaces[b].heightAt(sheet.origin))
				return;
			const std::optional<Vec3> spot = meetingOn(surfaces[b], sheet.origin, reach * axes[number]);
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
			seeds.hot_spot_order = number;
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
