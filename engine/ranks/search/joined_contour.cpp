#include "ranks/search/joined_contour.h"

#include "base/parallel_for.h"
#include "contour/sheet_pieces.h"
#include "ranks/data/share.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/neighborhood.h"
#include "ranks/search/contour_faces.h"
#include "ranks/team.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vp::ranks
{

namespace
{

/// Joins the mesh with those of other ranks. Gives its pieces the sides of the sheet on which they lie with what hangs
/// together with them elsewhere.
Borders joinPiecesOf(Team& team, const Share& share, const grid::BlockSet& blocks, const contour::ContourParts& parts,
                     std::span<const find::BlockCut> cuts, const contour::ClipBox& box, const mesh::SheetMesh& mesh,
                     contour::Pieces& pieces)
{
	pieces = contour::piecesOf(blocks, parts.surfaces, box, mesh);
	MarkedPieces marked = numbered(pieces.of_vertex);
	for (std::size_t v = 0; v < pieces.of_vertex.size(); ++v)
		marked.marks[marked.of_vertex[v]] = pieces.sides[pieces.of_vertex[v]];
	Borders borders = joinBorders(team, blocks, share.whole, cuts, marked, mesh);
	for (std::size_t v = 0; v < pieces.of_vertex.size(); ++v)
		pieces.sides[pieces.of_vertex[v]] = marked.marks[marked.of_vertex[v]];
	return borders;
}

/// Drops the pieces that touch the sheet at no rank.
Borders keepOnSheetOfAll(Team& team, const Share& share, const grid::BlockSet& blocks, contour::ContourParts&& parts,
                         const contour::ClipBox& box, mesh::SheetMesh& mesh)
{
	std::vector<find::BlockCut> cuts;
	for (find::CellCut& cut : parts.cuts)
		cuts.push_back({std::move(cut)});
	contour::Pieces pieces;
	Borders borders = joinPiecesOf(team, share, blocks, parts, cuts, box, mesh, pieces);
	if (!borders.hangs && anyOf(team, contour::keepTouching(pieces, mesh)))
		borders = joinPiecesOf(team, share, blocks, parts, cuts, box, mesh, pieces);
	return borders;
}

// Grows the contour of one value.
Result<GrownContour> growOverRanks(Team& team, const Share& share, const grid::BlockSet& blocks,
                                   const contour::BoxContourer& contourer, double value, Timeline* timeline)
{
	const TimedSection section(timeline, "contour");
	const Error hanging = sizesDiffer("contour");
	GrownContour contour;
	contour.value = value;
	if (!contourer.mayHave(value))
		return contour;
	const std::vector<Box> boxes = boxesOf(team, blocks);
	Result<contour::ContourParts> parts = contourer.growParts(value, boxesOfOthers(team, boxes));
	if (!parts)
		return parts.error();
	const ReachedGroups groups = reachedGroups(team, boxes, blocks, *parts);
	if (groups.hangs)
		return hanging;
	contour::keepGroups(groups.reached, *parts);
	contour.seeds = parts->seeds;
	contour.generations = parts->generations;
	for (const find::CellCut& cut : parts->cuts)
		contour.cells_touched += cut.cells.size();
	contour.mesh = contourer.clippedMesh(parts->surfaces, parts->cuts);
	contour.borders = keepOnSheetOfAll(team, share, blocks, std::move(*parts), contourer.box(), contour.mesh);
	if (contour.borders.hangs)
		return hanging;
	contour.components = contour.borders.components;
	contour.cells = contour::cellsOf(contour.mesh);
	return contour;
}

} // namespace

Box rectOf(const Ranks& ranks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh)
{
	return ranks.sum(contour::rectOf(sheet, mesh), [](Box& all, const Box& other) { all.include(other); });
}

void shareRange(const Ranks& ranks, contour::BoxContourer& contourer)
{
	if (!ranks.team())
		return;
	constexpr double kFar = std::numeric_limits<double>::infinity();
	struct Range
	{
		double least;
		double most;
	};
	const auto own = contourer.range().value_or(std::pair(kFar, -kFar));
	Range range{own.first, own.second};
	sumOverAll(*ranks.team(), range,
	           [](Range& all, const Range& other)
	           {
		           all.least = std::min(all.least, other.least);
		           all.most = std::max(all.most, other.most);
	           });
	if (range.least <= range.most)
		contourer.setRange(std::pair(range.least, range.most));
}

Result<std::vector<GrownContour>> growContours(const Ranks& ranks, const grid::BlockSet& blocks,
                                               const contour::BoxContourer& contourer, std::span<const double> values,
                                               Timeline* timeline)
{
	std::vector<GrownContour> contours(values.size());
	std::vector<Status> done(values.size(), Nothing{});
	if (ranks.team())
	{
		for (std::size_t i = 0; i < values.size(); ++i)
			if (auto grown = growOverRanks(*ranks.team(), ranks.share(), blocks, contourer, values[i], timeline))
				contours[i] = std::move(*grown);
			else
				return grown.error();
		return contours;
	}
	tracedFor(std::size_t(0), values.size(),
	          [&](std::size_t i)
	          {
		          if (auto grown = contourer.grow(values[i], timeline))
			          contours[i] = {std::move(*grown)};
		          else
			          done[i] = grown.error();
	          });
	for (const Status& each : done)
		if (!each)
			return each.error();
	return contours;
}

} // namespace vp::ranks
