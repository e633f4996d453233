#include "session/hot_spot_pieces.h"

#include "find/block_cut.h"
#include "find/curved_sheet.h"
#include "seed/boundary_cut.h"
#include "session/lone_faces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace vp::session
{

namespace
{

using Seeds = std::vector<seed::SheetSeeds>; // per sheet

bool isEmpty(const seed::SheetSeeds& seeds)
{
	return std::ranges::all_of(seeds.cells, [](const auto& cells) { return cells.empty(); });
}

/// What a rank has found for a sheet.
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

/// The faces through which a sheet may lead into the parts of other ranks.
class Ways
{
public:
	Ways(Team& team, const std::vector<Box>& boxes, const grid::BlockSet& blocks, const cut::SheetCut& sheet)
	{
		const BoxesOfOthers others(team, boxes);
		std::optional<seed::SheetWindow> window;
		if (sheet.sheet.window)
			window.emplace(sheet.sheet);
		std::vector<surface::BlockSurface> surfaces;
		if (sheet.sheet.form)
			surfaces = find::surfacesOf(blocks, sheet.sheet, sheet.field);
		for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		{
			const grid::Block& block = blocks.blocks[b];
			const auto take = [&](const grid::BoundaryIndex::Face& at)
			{
				std::optional<LoneFace> face = loneFace(blocks, {b, at.cell}, static_cast<int>(at.face));
				Box box;
				if (face)
					for (const Vec3& corner : face->corners)
						box.include(corner);
				if (face && others.meet(box))
					faces_.push_back(std::move(*face));
			};
			const auto search = [&](const auto& grid, const auto& surface)
			{
				seed::visitBoundaryCut(grid, block.boundary, block.bounds, surface, window ? &*window : nullptr, take,
				                       [](const auto&) {});
			};
			std::visit([&](const auto& grid)
			           { sheet.sheet.form ? search(grid, surfaces[b]) : search(grid, sheet.sheet.plane()); },
			           block.grid);
		}
		across_ = facesAcross(team, boxes, faces_);
		hang_ = facesHang(team, boxes, faces_, across_);
		for (std::uint32_t f = 0; f < faces_.size(); ++f)
			if (!across_[f].empty())
				of_cell_[{faces_[f].cell.block, faces_[f].cell.cell}].push_back(f);
	}

	bool hang() const { return hang_; }
	const LoneFace& face(std::uint32_t number) const { return faces_[number]; }
	/// Of the cells that were found: those that have a way out.
	std::vector<std::pair<std::uint32_t, CellId>> foundIn(const grid::BlockSet& blocks,
	                                                      const cut::SheetCut& sheet) const
	{
		std::vector<std::pair<std::uint32_t, CellId>> found;
		for (std::uint32_t b = 0; b < sheet.cuts.size() && !of_cell_.empty(); ++b)
			find::forEachCutCell(blocks.blocks[b], sheet.cuts[b],
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
			std::ranges::for_each(across_[f], visit);
	}

private:
	std::vector<LoneFace> faces_;
	std::vector<std::vector<FaceAcross>> across_;
	std::map<std::pair<std::uint32_t, CellId>, std::vector<std::uint32_t>> of_cell_; // with a way out
	bool hang_ = false;
};

/// The fronts of all sheets, as far as they have come in this rank.
class Fronts
{
public:
	Fronts(Team& team, const grid::BlockSet& blocks, const std::vector<Box>& boxes, const cut::Cut& cut)
	    : blocks_(blocks), near_(team, boxes, 0.0)
	{
		for (const cut::SheetCut& sheet : cut.sheets)
			ways_.emplace_back(team, boxes, blocks, sheet);
		told_.resize(ways_.size());
		taken_.resize(ways_.size());
	}

	bool hang() const { return std::ranges::any_of(ways_, &Ways::hang); }

	/// Tells the ranks beside this one of ways that no round before had. Takes theirs as seeds. Returns true if some
	/// are new.
	bool exchange(const cut::Cut& cut, Seeds& seeds)
	{
		std::vector<std::vector<std::pair<std::uint32_t, CellId>>> found;
		for (std::uint32_t s = 0; s < ways_.size(); ++s)
		{
			found.push_back(ways_[s].foundIn(blocks_, cut.sheets[s]));
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
	const grid::BlockSet& blocks_;
	Neighborhood near_;
	std::vector<Ways> ways_;                                          // per sheet
	std::vector<std::vector<std::pair<std::uint32_t, CellId>>> told_; // cells with a way out; ascending
	std::vector<std::set<std::pair<std::uint32_t, CellId>>> taken_;   // as seeds
};

} // namespace

Result<cut::Cut> cutHotSpotPieces(Team& team, cut::Cutter& cutter, cut::CutRequest request, const std::stop_token& stop)
{
	request.last = nullptr;
	Result<Seeds> seeds = cutter.seedsOf(request);
	if (!seeds)
		return seeds.error();
	agree(team, *seeds);
	request.given_seeds = &*seeds;
	Result<cut::Cut> cut = cutter.cut(request, stop);
	if (!cut)
		return cut;
	const grid::BlockSet& blocks = cutter.blocks();
	Fronts fronts(team, blocks, boxesOf(team, blocks), *cut);
	if (fronts.hang())
		return Error{ErrorKind::input, "cells of different sizes meet between two processes; give each such group of "
		                               "blocks to one of them by fewer processes, or use vprobe"};
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

void agreeOnHotSpots(Team& team, cut::Cut& cut)
{
	for (cut::SheetCut& sheet : cut.sheets)
		sheet.seeds.hot_spot_inside = anyOf(team, sheet.seeds.hot_spot_inside);
}

} // namespace vp::session
