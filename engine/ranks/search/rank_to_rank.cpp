#include "ranks/search/rank_to_rank.h"

#include "find/block_cut.h"
#include "find/curved_sheet.h"
#include "probe/probe.h"
#include "ranks/data/share.h"
#include "ranks/join/faces_between_shares.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/join/unmatched_faces.h"
#include "seed/boundary_cut.h"
#include "seed/cut_cells.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace vp::ranks
{

namespace
{

using Seeds = std::vector<seed::SheetSeeds>; // per sheet

bool isEmpty(const seed::SheetSeeds& seeds)
{
	return std::ranges::all_of(seeds.cells, [](const auto& cells) { return cells.empty(); });
}

/// The result of a rank's search for a sheet's hot spot.
struct FoundSpot
{
	bool is_inside;
	bool has_seed;
	double order;
	std::optional<Vec3> moved_to;
};

/// Leaves the seeds of one rank for each sheet.
void agree(Team& team, Seeds& seeds)
{
	MessageWriter message;
	for (const seed::SheetSeeds& own : seeds)
		message.put(FoundSpot{own.hot_spot_inside, !isEmpty(own), own.hot_spot_order, own.moved_to});
	std::vector<std::vector<FoundSpot>> of_ranks;
	for (const Bytes& bytes : team.gatherAll(message.take()))
	{
		std::vector<FoundSpot>& of_rank = of_ranks.emplace_back();
		for (MessageReader reader(bytes); !reader.atEnd();)
			of_rank.push_back(reader.get<FoundSpot>());
	}
	for (std::size_t s = 0; s < seeds.size(); ++s)
	{
		const bool is_inside = std::ranges::any_of(of_ranks, [&](const auto& of_rank) { return of_rank[s].is_inside; });
		int first = -1;
		for (int rank = 0; rank < team.size(); ++rank)
		{
			const FoundSpot& spot = of_ranks[static_cast<std::size_t>(rank)][s];
			if (spot.has_seed && spot.is_inside == is_inside &&
			    (first < 0 || spot.order < of_ranks[static_cast<std::size_t>(first)][s].order))
				first = rank;
		}
		seeds[s].hot_spot_inside = is_inside;
		seeds[s].moved_to.reset();
		if (first >= 0)
			seeds[s].moved_to = of_ranks[static_cast<std::size_t>(first)][s].moved_to;
		if (first == team.rank())
			continue;
		for (std::vector<CellId>& cells : seeds[s].cells)
			cells.clear();
		seeds[s].count = 0;
	}
}

/// A sheet at its place.
struct PlacedSheet
{
	probe::Sheet sheet;
	std::vector<surface::BlockSurface> surfaces; // per block, of one that is no plane
};

std::vector<PlacedSheet> placedSheets(const grid::BlockSet& blocks, const cut::CutRequest& request)
{
	std::vector<PlacedSheet> placed;
	for (const probe::Sheet& sheet : probe::placed(request.probe).sheets)
	{
		PlacedSheet& at = placed.emplace_back(PlacedSheet{probe::content(sheet), {}});
		if (at.sheet.form)
			at.surfaces = find::surfacesOf(blocks, at.sheet, request.fieldOf(placed.size() - 1));
	}
	return placed;
}

/// The faces through which a sheet may lead into the parts of other ranks, and the boundary that the whole has.
class ExitFaces
{
public:
	/// whole: per block, the block that one process would have in its place.
	ExitFaces(Team& team, const std::vector<Box>& boxes, const grid::BlockSet& blocks,
	          std::span<const std::uint32_t> whole, const PlacedSheet& placed)
	    : blocks_(blocks), whole_(whole), others_(boxesOfOthers(team, boxes)), boundary_cells_(blocks.blocks.size())
	{
		std::optional<seed::SheetWindow> window;
		if (placed.sheet.window)
			window.emplace(placed.sheet);
		for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		{
			const grid::Block& block = blocks.blocks[b];
			const auto search = [&](const auto& grid, const auto& surface)
			{
				seed::visitBoundaryCut(
				    grid, block.boundary, block.bounds, surface, window ? &*window : nullptr,
				    [&](const grid::BoundaryIndex::Face& face) { addCut(b, face); },
				    [&](const grid::BoundaryIndex::Face& face) { add(b, face, true); });
			};
			std::visit([&](const auto& grid)
			           { placed.sheet.form ? search(grid, placed.surfaces[b]) : search(grid, placed.sheet.plane()); },
			           block.grid);
		}
		matched_ = matchFaces(team, boxes, faces_);
		for (std::uint32_t f = 0; f < faces_.size(); ++f)
		{
			const auto& [block, cell] = faces_[f].cell;
			const bool has_other_side = !matched_.across[f].empty();
			if (has_other_side && flat_[f])
				shown_across_.emplace(block, cell);
			else if (has_other_side)
				of_cell_[{block, cell}].push_back(f);
			if (!flat_[f] && !isWithinLattice(f))
				boundary_cells_[block].push_back(cell);
		}
	}

	bool hang() const { return matched_.hang; }
	const UnmatchedFace& face(std::uint32_t number) const { return faces_[number]; }
	/// The cells of a block of which the sheet cuts a face on the boundary that one process has.
	const std::vector<CellId>& boundaryCells(std::size_t block) const { return boundary_cells_[block]; }
	/// Drops faces in the sheet on which a cell of another rank lies: the cell is cut, and so it alone may show them.
	void dropShownAcross(std::uint32_t block, std::vector<grid::BoundaryIndex::Face>& faces) const
	{
		std::erase_if(faces, [&](const auto& face) { return shown_across_.contains({block, face.cell}); });
	}
	/// Returns the found cells that have a face on the border to another rank.
	std::vector<std::pair<std::uint32_t, CellId>> foundIn(const cut::SheetCut& sheet) const
	{
		std::vector<std::pair<std::uint32_t, CellId>> found;
		for (std::uint32_t b = 0; b < sheet.cuts.size() && !of_cell_.empty(); ++b)
			find::forEachCutCell(blocks_.blocks[b], sheet.cuts[b],
			                     [&](CellId cell)
			                     {
				                     if (of_cell_.contains({b, cell}))
					                     found.emplace_back(b, cell);
			                     });
		std::ranges::sort(found);
		return found;
	}
	/// Calls visit(face across) for every way out of a cell.
	template <class Visit>
	void forWaysOut(const std::pair<std::uint32_t, CellId>& cell, const Visit& visit) const
	{
		for (const std::uint32_t f : of_cell_.at(cell))
			std::ranges::for_each(matched_.across[f], visit);
	}

private:
	/// Returns true if a face at a seam in this rank is not on the boundary that one process would have.
	bool isSeamWithinLattice(std::uint32_t block, const grid::BoundaryIndex::Face& face) const
	{
		const grid::BlockSeams* seams = blocks_.interfaces.of(block);
		return seams && std::ranges::any_of(seams->of(face.cell, face.face), [&](const grid::SeamLink& link)
		                                    { return areOneLattice(blocks_, whole_, block, link.block); });
	}
	bool isWithinLattice(std::uint32_t number) const
	{
		return std::ranges::any_of(matched_.across[number], [&](const FaceAcross& across)
		                           { return areOneLattice(blocks_, whole_, faces_[number].cell.block, across.block); });
	}
	/// Returns whether it is one that may lie on those of other ranks.
	bool add(std::uint32_t block, const grid::BoundaryIndex::Face& at, bool is_flat)
	{
		std::optional<UnmatchedFace> face = unmatchedFace(blocks_, {block, at.cell}, static_cast<int>(at.face));
		if (!face || !touchesAny(face->box(), others_))
			return false;
		face->number = static_cast<std::uint32_t>(faces_.size());
		faces_.push_back(std::move(*face));
		flat_.push_back(is_flat);
		return true;
	}
	void addCut(std::uint32_t block, const grid::BoundaryIndex::Face& face)
	{
		if (!isSeamWithinLattice(block, face) && !add(block, face, false))
			boundary_cells_[block].push_back(face.cell);
	}

	const grid::BlockSet& blocks_;
	std::span<const std::uint32_t> whole_;
	std::vector<Box> others_;
	std::vector<UnmatchedFace> faces_;
	std::vector<bool> flat_; // per face: it lies in the sheet
	MatchedFaces matched_;
	std::vector<std::vector<CellId>> boundary_cells_;         // per block
	std::set<std::pair<std::uint32_t, CellId>> shown_across_; // with a face in the sheet that meets a cell
	std::map<std::pair<std::uint32_t, CellId>, std::vector<std::uint32_t>> of_cell_; // with a way out
};

/// Seeds of all sheets as one process has them, which has no boundary between the parts of ranks.
Result<Seeds> seedsOfWhole(Team& team, cut::Cutter& cutter, const cut::CutRequest& request,
                           std::span<const PlacedSheet> sheets, std::span<const ExitFaces> ways)
{
	Result<Seeds> seeds = cutter.seedsOf(request);
	if (!seeds)
		return seeds;
	const bool is_automatic = request.seeds.mode == seed::SeedMode::automatic;
	cut::CutRequest only_spots = request;
	only_spots.seeds.mode = seed::SeedMode::hotspot;
	Result<Seeds> spots = is_automatic ? cutter.seedsOf(only_spots) : *seeds;
	if (!spots)
		return spots;
	agree(team, *spots);
	if (request.seeds.mode == seed::SeedMode::hotspot)
		return spots;
	const grid::BlockSet& blocks = cutter.blocks();
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		seed::SheetSeeds& of_sheet = (*seeds)[s];
		// With seeds in every leaf of the block tree, or at every border, each rank finds all pieces of its part.
		if (sheets[s].sheet.form ? is_automatic : !request.threshold)
			continue;
		of_sheet.count = 0;
		for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		{
			std::vector<CellId>& cells = of_sheet.cells[b];
			cells = ways[s].boundaryCells(b);
			if (is_automatic && (*spots)[s].hot_spot_inside)
				cells.insert(cells.end(), (*spots)[s].cells[b].begin(), (*spots)[s].cells[b].end());
			if (!sheets[s].sheet.form)
				std::visit(
				    [&](const auto& grid)
				    {
					    seed::visitCutCells(grid, blocks.blocks[b].inverted_tree, sheets[s].sheet.plane(),
					                        [&](CellId cell) { cells.push_back(cell); });
				    },
				    blocks.blocks[b].grid);
			ways[s].dropShownAcross(b, of_sheet.faces_in_plane[b]);
			of_sheet.count += cells.size();
		}
	}
	return seeds;
}

/// The fronts of all sheets, as far as they have come in this rank.
class Fronts
{
public:
	Fronts(Team& team, const std::vector<Box>& boxes, std::span<const ExitFaces> ways)
	    : near_(team, boxes, 0.0), ways_(ways), told_(ways.size()), taken_(ways.size())
	{
	}

	/// Tells the ranks beside this one of ways that no round before had. Takes theirs as seeds. Returns true if some
	/// are new.
	bool exchange(const cut::Cut& cut, Seeds& seeds)
	{
		std::vector<std::vector<std::pair<std::uint32_t, CellId>>> found;
		for (std::uint32_t s = 0; s < ways_.size(); ++s)
		{
			found.push_back(ways_[s].foundIn(cut.sheets[s]));
			for (const auto& cell : found.back())
				if (!std::ranges::binary_search(told_[s], cell))
					ways_[s].forWaysOut(cell,
					                    [&](const FaceAcross& across)
					                    {
						                    near_.messageFor(across.rank).put(s);
						                    near_.messageFor(across.rank).put(across.number);
					                    });
		}
		told_ = found;
		bool any = false;
		for (const Bytes& bytes : near_.exchange())
			for (MessageReader reader(bytes); !reader.atEnd();)
			{
				const auto s = reader.get<std::uint32_t>();
				const mesh::BlockCell cell = ways_[s].face(reader.get<std::uint32_t>()).cell;
				if (std::ranges::binary_search(found[s], std::pair(cell.block, cell.cell)) ||
				    !taken_[s].emplace(cell.block, cell.cell).second)
					continue;
				seeds[s].cells[cell.block].push_back(cell.cell);
				++seeds[s].count;
				any = true;
			}
		return any;
	}

private:
	Neighborhood near_;
	std::span<const ExitFaces> ways_;                                 // per sheet
	std::vector<std::vector<std::pair<std::uint32_t, CellId>>> told_; // cells with a way out; ascending
	std::vector<std::set<std::pair<std::uint32_t, CellId>>> taken_;   // as seeds
};

} // namespace

bool goesFromRankToRank(const cut::CutRequest& request)
{
	if (request.surface)
		return false;
	if (request.seeds.mode == seed::SeedMode::hotspot)
		return true;
	const auto is_plane = [](const probe::Sheet& sheet) { return !sheet.form; };
	return (request.threshold && std::ranges::any_of(request.probe.sheets, is_plane)) ||
	       (request.seeds.mode == seed::SeedMode::boundary && !std::ranges::all_of(request.probe.sheets, is_plane));
}

namespace
{

// whole: per block, the block that one process would have in its place.
Result<cut::Cut> cutFromRankToRank(Team& team, std::span<const std::uint32_t> whole, cut::Cutter& cutter,
                                   cut::CutRequest request, const std::stop_token& stop)
{
	request.last = nullptr;
	const grid::BlockSet& blocks = cutter.blocks();
	const std::vector<Box> boxes = boxesOf(team, blocks);
	const std::vector<PlacedSheet> sheets = placedSheets(blocks, request);
	std::vector<ExitFaces> ways;
	for (const PlacedSheet& sheet : sheets)
		ways.emplace_back(team, boxes, blocks, whole, sheet);
	if (std::ranges::any_of(ways, &ExitFaces::hang))
		return sizesDiffer();
	Result<Seeds> seeds = seedsOfWhole(team, cutter, request, sheets, ways);
	if (!seeds)
		return seeds.error();
	request.given_seeds = &*seeds;
	Result<cut::Cut> cut = cutter.cut(request, stop);
	if (!cut)
		return cut;
	Fronts fronts(team, boxes, ways);
	for (;;)
	{
		const bool is_new = fronts.exchange(*cut, *seeds);
		if (!anyOf(team, is_new))
			return cut;
		if (!is_new)
			continue;
		cut = cutter.cut(request, stop);
		if (!cut)
			return cut;
	}
}

// With other seeds: whether a hot spot lies in the part of any rank.
void agreeOnHotSpots(Team& team, cut::Cut& cut)
{
	for (cut::SheetCut& sheet : cut.sheets)
		sheet.seeds.hot_spot_inside = anyOf(team, sheet.seeds.hot_spot_inside);
}

} // namespace

Result<cut::Cut> carryOut(const Ranks& ranks, cut::Cutter& cutter, cut::CutRequest request, const std::stop_token& stop)
{
	if (!ranks.team())
		return cutter.cut(request, stop);
	const bool spots_may_move = request.seeds.outside == seed::OutsidePolicy::nearest;
	Result<cut::Cut> cut = goesFromRankToRank(request)
	                           ? cutFromRankToRank(*ranks.team(), ranks.share().whole, cutter, std::move(request), stop)
	                           : cutter.cut(request, stop);
	if (cut && shareAPack(ranks) && !stop.stop_requested())
		dropFacesBetweenShares(*ranks.team(), cutter.blocks(), ranks.share().whole, *cut);
	if (cut && !spots_may_move && !stop.stop_requested())
		agreeOnHotSpots(*ranks.team(), *cut);
	return cut;
}

} // namespace vp::ranks
