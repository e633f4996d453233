#include "refine/shape_refiner.h"

#include "base/parallel_for.h"
#include "refine/corner_tetrahedra.h"
#include "refine/part_ranges.h"
#include "refine/tetrahedron.h"

#include <algorithm>
#include <atomic>

namespace vp::refine
{

namespace
{

// A few steps halve all edges of a part, which leaves a quarter of what is off. Cells that need more are not refined
// on.
constexpr int kMaxLevels = 400;

/// Appends lists one after the other.
template <class T>
void appendAll(std::vector<T>& all, const std::vector<std::vector<T>>& lists)
{
	std::vector<std::size_t> starts{all.size()};
	for (const std::vector<T>& list : lists)
		starts.push_back(starts.back() + list.size());
	all.resize(starts.back());
	tracedFor(std::size_t(0), lists.size(),
	          [&](std::size_t l)
	          { std::ranges::copy(lists[l], all.begin() + static_cast<std::ptrdiff_t>(starts[l])); });
}

} // namespace

ShapeRefiner::ShapeRefiner(const grid::CurvedCells& curved, const NearCells& cells, const Sheets& sheets, double reach)
    : curved_(curved), cells_(cells), sheets_(sheets), slack_(1e-12 * std::max(reach, sheets.reach())),
      least_(1e-14 * reach)
{
}

Vec3 ShapeRefiner::positionOf(std::uint32_t point) const
{
	const double* numbers = numbersOf(point);
	return {numbers[0], numbers[1], numbers[2]};
}

PartList ShapeRefiner::refine(std::size_t max_parts, const std::stop_token& stop)
{
	makeFirstParts();
	for (int level = 0; !parts_.empty() && !stop.stop_requested(); ++level)
	{
		findEdges();
		stopLargeCells(max_parts, level > kMaxLevels);
		halveParts();
		if (parts_.size() + done_.size() > kMaxParts)
			throw TooManyParts("too many parts");
	}
	return list();
}

/// The tetrahedra that the corners of the cells make.
void ShapeRefiner::makeFirstParts()
{
	KeyNumbers numbers(4 * cells_.size());
	std::vector<std::array<std::uint8_t, 4>> tetrahedra;
	std::array<std::uint32_t, grid::kMaxShapePoints> ids;
	std::array<std::uint32_t, grid::kMaxShapePoints> points;
	for (std::uint32_t i = 0; i < cells_.size(); ++i)
	{
		const NearCell& near = cells_[i];
		const CellKind& kind = *near.kind;
		for (std::size_t c = 0; c < kind.corners(); ++c)
		{
			ids[c] = static_cast<std::uint32_t>(curved_.node(near.cell, kind.cornerNode(c)));
			const auto found = numbers.find(ids[c], static_cast<std::uint32_t>(points_.size()));
			points[c] = found.number;
			if (!found.is_new)
				continue;
			points_.push_back({Vec3(0.0), Vec3(0.0), PartPoint::kNode, {ids[c], ids[c]}});
			numbers_.resize(numbers_.size() + cells_.width());
			double* of_point = &numbers_[numbers_.size() - cells_.width()];
			const Vec3 at = curved_.points[ids[c]];
			std::copy_n(&at.x, 3, of_point);
			cells_.valuesOf(ids[c], of_point + 3);
		}
		splitCorners(kind.shape(), std::span(ids).first(kind.corners()), tetrahedra);
		for (auto& corners : tetrahedra)
		{
			const auto place = [&](std::size_t c) { return kind.cornerPlace(corners[c]); };
			const double volume = glm::dot(glm::cross(place(1) - place(0), place(2) - place(0)), place(3) - place(0));
			if ((volume < 0.0) != kind.isMirrored())
				std::swap(corners[2], corners[3]);
			Part part{};
			part.near = i;
			part.edges.fill(EdgeTable::kUnknown);
			for (std::size_t c = 0; c < 4; ++c)
			{
				part.points[c] = points[corners[c]];
				part.places[c] = Vec3f(place(c));
			}
			if (mayMeet(part))
				parts_.push_back(part);
		}
	}
}

/// False where no sheet meets what the cell has between the corners of a part.
bool ShapeRefiner::mayMeet(const Part& part) const
{
	Vec3f lo = part.places[0];
	Vec3f hi = lo;
	for (const Vec3f& place : part.places)
	{
		lo = glm::min(lo, place);
		hi = glm::max(hi, place);
	}
	const double bend = cells_[part.near].bendWithin(Vec3(lo), Vec3(hi));
	const std::array<Vec3, 4> corners{positionOf(part.points[0]), positionOf(part.points[1]),
	                                  positionOf(part.points[2]), positionOf(part.points[3])};
	return sheets_.meetHull(corners, bend + slack_);
}

/// Cells that the next step may give too many parts halve no more edges than other cells have halved already. No other
/// cell halves the rest of their edges either, so both sides of a face stay alike. This depends on whole levels, and so
/// not on the number of threads.
void ShapeRefiner::stopLargeCells(std::size_t max_parts, bool all)
{
	if (2 * parts_.size() + done_.size() <= std::min(max_parts, kMaxPartsOfCell) && !all)
		return;
	done_of_.resize(cells_.size());
	is_stopped_.resize(cells_.size());
	is_unfinished_.resize(cells_.size());
	for (; counted_ < done_.size(); ++counted_)
		++done_of_[done_[counted_].near];
	if (!all_are_stopped_)
	{
		std::vector<std::uint32_t> parts_of(cells_.size());
		for (const Part& part : parts_)
			++parts_of[part.near];
		for (std::size_t i = 0; i < cells_.size(); ++i)
			is_stopped_[i] |= 2 * std::size_t(parts_of[i]) + done_of_[i] > kMaxPartsOfCell;
		all_are_stopped_ = all || 2 * parts_.size() + done_.size() > max_parts;
	}
	for (const Part& part : parts_)
	{
		if (!all_are_stopped_ && is_stopped_[part.near] == 0)
			continue;
		for (const std::uint32_t e : part.edges)
		{
			EdgeTable::Edge& edge = edges_[e];
			if (!(edge.priority > 0.0) || edge.is_halved != 0)
				continue;
			edge.priority = -1.0;
			if (is_unfinished_[part.near] != 0)
				continue;
			is_unfinished_[part.near] = 1;
			if (const std::uint32_t cell = cells_[part.near].cell; unfinished_.cells++ == 0 || cell < unfinished_.first)
			{
				unfinished_.first = cell;
				unfinished_.by_cut = is_stopped_[part.near] == 0;
			}
		}
	}
}

void ShapeRefiner::halveParts()
{
	const std::size_t ranges = rangesOf(parts_.size());
	std::vector<std::vector<Part>> halves(ranges);
	std::vector<std::vector<DonePart>> done(ranges);
	forEachRange(parts_.size(),
	             [&](std::size_t r, std::size_t begin, std::size_t end)
	             {
		             for (std::size_t p = begin; p < end; ++p)
			             halve(parts_[p], halves[r], done[r]);
	             });
	parts_.clear();
	appendAll(parts_, halves);
	appendAll(done_, done);
}

/// Halves the edge with the largest error. If several edges have the same error, the first one by its ends is halved.
void ShapeRefiner::halve(const Part& part, std::vector<Part>& halves, std::vector<DonePart>& done)
{
	int edge = -1;
	double most = 0.0;
	const auto keyOf = [&](int e) { return EdgeTable::keyOf(part.points[kEdges[e][0]], part.points[kEdges[e][1]]); };
	for (int e = 0; e < 6; ++e)
		if (const double priority = edges_[part.edges[e]].priority;
		    priority > most || (edge >= 0 && priority == most && keyOf(e) < keyOf(edge)))
		{
			edge = e;
			most = priority;
		}
	if (edge < 0)
	{
		// Parts that touch a plane count, so both cells of a face in the plane are there.
		const std::array<Vec3, 4> corners{positionOf(part.points[0]), positionOf(part.points[1]),
		                                  positionOf(part.points[2]), positionOf(part.points[3])};
		if (sheets_.meetHull(corners, 0.0))
			done.push_back({part.points, part.near});
		return;
	}
	EdgeTable::Edge& halved = edges_[part.edges[edge]];
	std::atomic_ref(halved.is_halved).store(1, std::memory_order_relaxed);
	const auto [a, b] = kEdges[edge];
	for (const auto& [stays, goes] : {std::pair(a, b), std::pair(b, a)})
	{
		Part half = part;
		half.points[goes] = halved.point;
		half.places[goes] = 0.5f * (part.places[a] + part.places[b]);
		half.level = halved.level + 1u;
		for (int c = 0; c < 4; ++c)
			if (c != goes)
				half.edges[kEdgeBetween[goes][c]] = EdgeTable::kUnknown;
		if (mayMeet(half))
			halves.push_back(half);
	}
}

} // namespace vp::refine
