#include "seed/seeds.h"

#include "locate/find_cell.h"
#include "seed/boundary_cut.h"
#include "seed/cut_cells.h"
#include "seed/nearest_cut.h"
#include "seed/row_seeds.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace vp::seed
{

namespace
{

bool isFlat(const grid::Block& block, const surface::Plane& plane, CellId cell, std::uint32_t face)
{
	return std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces faces;
		    grid.cellFaces(cell, faces);
		    const auto on_plane = [&](PointId p) { return plane.signedDistance(grid.point(p)) == 0.0; };
		    return std::ranges::all_of(faces[static_cast<int>(face)], on_plane);
	    },
	    block.grid);
}

// Returns true if something that lies on a face in the plane at a seam shows the face: a cut cell, or a face that comes
// before it.
bool isShownAcrossSeam(const grid::BlockSet& blocks, const grid::Interfaces& interfaces, const surface::Plane& plane,
                       std::size_t b, const grid::BoundaryIndex::Face& face)
{
	const grid::BlockSeams* seams = interfaces.of(b);
	if (!seams)
		return false;
	for (const grid::SeamLink& link : seams->of(face.cell, face.face))
	{
		const grid::Block& across = blocks.blocks[link.block];
		if (std::visit([&](const auto& grid) { return isCut(grid, plane, link.other); }, across.grid))
			return true;
		const bool before =
		    link.hang != grid::Hang::none
		        ? link.hang == grid::Hang::large // its parts are shown
		        : std::tuple<std::size_t, CellId, std::uint32_t>(link.block, link.other, link.other_face) <
		              std::tuple<std::size_t, CellId, std::uint32_t>(b, face.cell, face.face);
		if (before && isFlat(across, plane, link.other, link.other_face))
			return true;
	}
	return false;
}

// The seed at the hot spot, in the first block that holds it; in every one where `everywhere` asks for it.
void seedHotSpot(const grid::BlockSet& blocks, const Vec3& hot_spot, const surface::Plane& plane,
                 const SheetWindow* window, bool everywhere, SheetSeeds& seeds)
{
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
	{
		const grid::Block& block = blocks.blocks[b];
		const locate::Located located = locate::findCell(block, kNoCell, hot_spot);
		seeds.hops += located.hops;
		seeds.boundary_tests += located.boundary_tests;
		if (!located.found())
			continue;
		seeds.hot_spot_inside = true;
		const CellId seed =
		    std::visit([&](const auto& grid) { return nearestCutCell(grid, plane, window, located.cell); }, block.grid);
		if (seed == kNoCell)
			continue; // on the rim of this block; another one may hold it as well
		seeds.cells[b].push_back(seed);
		if (!everywhere)
			return;
	}
}

// Keeps those boundary faces in the plane that nothing else shows.
void keepFacesToShow(const grid::BlockSet& blocks, const surface::Plane& plane,
                     std::vector<std::vector<grid::BoundaryIndex::Face>>& faces)
{
	const grid::Interfaces among = grid::knowsSeams(blocks) ? grid::Interfaces() : grid::interfacesAmong(blocks, faces);
	const grid::Interfaces& interfaces = grid::knowsSeams(blocks) ? blocks.interfaces : among;
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		std::erase_if(faces[b],
		              [&](const grid::BoundaryIndex::Face& face)
		              {
			              const auto isCutCell = [&](const auto& grid) { return isCut(grid, plane, face.cell); };
			              return std::visit(isCutCell, blocks.blocks[b].grid) ||
			                     isShownAcrossSeam(blocks, interfaces, plane, b, face);
		              });
}

// Returns true if a face of a grid with straight axes may lie in the plane, far beyond what rounding can do.
bool mayHoldFaces(const surface::Plane& plane)
{
	const Vec3 size = glm::abs(plane.normal());
	const double second = std::max(std::min(size.x, size.y), std::min(std::max(size.x, size.y), size.z));
	return second < 1e-3;
}

} // namespace

SheetSeeds findSeeds(const grid::BlockSet& blocks, const probe::Sheet& sheet, const SeedOptions& options,
                     const std::vector<bool>& needs_none)
{
	SheetSeeds seeds;
	seeds.cells.resize(blocks.blocks.size());
	seeds.faces_in_plane.resize(blocks.blocks.size());
	seeds.rim.resize(blocks.blocks.size());
	const surface::Plane plane = sheet.plane();
	const std::optional<SheetWindow> window = sheet.window ? std::optional<SheetWindow>(sheet) : std::nullopt;
	const Vec3 hot_spot = window ? window->hotSpot() : sheet.origin;
	const bool seeds_boundary = options.mode != SeedMode::hotspot;
	// A window may lie wholly inside of blocks that overlap: none of their boundaries leads into it.
	if (options.mode != SeedMode::boundary)
		seedHotSpot(blocks, hot_spot, plane, window ? &*window : nullptr, seeds_boundary && window, seeds);

	const bool moves_hot_spot =
	    options.mode != SeedMode::boundary && !seeds.hot_spot_inside && options.outside == OutsidePolicy::nearest;
	double nearest = std::numeric_limits<double>::infinity();
	std::size_t nearest_block = 0;
	CellId nearest_cell = kNoCell;
	for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
	{
		if (!seeds_boundary && !moves_hot_spot)
			break;
		if (!needs_none.empty() && needs_none[b] && !moves_hot_spot && !mayHoldFaces(plane))
			continue;
		const grid::Block& block = blocks.blocks[b];
		std::visit(
		    [&](const auto& grid)
		    {
			    seeds.boundary_tests += visitBoundaryCut(
			        grid, block.boundary, block.bounds, plane, window ? &*window : nullptr,
			        [&](const grid::BoundaryIndex::Face& face)
			        {
				        if (seeds_boundary && (seeds.cells[b].empty() || seeds.cells[b].back() != face.cell))
					        seeds.cells[b].push_back(face.cell);
				        if (!options.lattice && !moves_hot_spot)
					        return;
				        const CutFace cut = cutFace(grid, plane, face);
				        if (options.lattice)
					        seeds.rim[b].push_back(cut);
				        if (!moves_hot_spot)
					        return;
				        const Vec3 point = nearestOnSegment(cut.from, cut.to, hot_spot);
				        const double distance = glm::length(point - hot_spot);
				        if (distance < nearest)
				        {
					        nearest = distance;
					        nearest_block = b;
					        nearest_cell = face.cell;
					        seeds.moved_to = point;
				        }
			        },
			        [&](const grid::BoundaryIndex::Face& face)
			        {
				        if (seeds_boundary)
					        seeds.faces_in_plane[b].push_back(face);
			        });
			    if constexpr (std::is_same_v<std::decay_t<decltype(grid)>, grid::CurvilinearGrid>)
				    if (seeds_boundary && !block.knows_folds)
				    {
					    const std::vector<CellId> of_rows = rowSeeds(grid, plane);
					    seeds.cells[b].insert(seeds.cells[b].end(), of_rows.begin(), of_rows.end());
				    }
			    if (seeds_boundary)
				    visitCutCells(grid, block.inverted_tree, plane,
				                  [&](CellId cell) { seeds.cells[b].push_back(cell); });
		    },
		    block.grid);
	}
	keepFacesToShow(blocks, plane, seeds.faces_in_plane);
	if (nearest_cell != kNoCell)
		seeds.hot_spot_order = nearest;
	if (nearest_cell != kNoCell && !seeds_boundary)
		seeds.cells[nearest_block].push_back(nearest_cell);
	for (const std::vector<CellId>& cells : seeds.cells)
		seeds.count += cells.size();
	return seeds;
}

} // namespace vp::seed
