#include "refine/shape_refiner.h"

#include "refine/corner_tetrahedra.h"
#include "refine/tetrahedron.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace vp::refine
{

namespace
{

constexpr std::size_t kPartsAtOnce = 2048; // whatever the number of threads

// A few steps halve all edges of a part, which leaves a quarter of what is off. Cells that need more are not refined
// on.
constexpr int kMaxLevels = 400;

/// Edges that were halved so often are left, whatever they are off. Two levels, mostly one, halve the length, and so
/// leave a quarter of what is off.
int maxLevel(double tolerance)
{
	return 6 + static_cast<int>(std::ceil(-std::log2(tolerance)));
}

/// The share of what an edge may be off that is left for how unlike a parabola it is. What an edge of the first two
/// thirds of another is off is at most 4/9 of the parabola, and twice the rest. So an edge beside one that is not off
/// is not off either. Else halving such edges would make parts that get thinner without end.
constexpr double kUnlike = 0.25;

template <class Body>
void forEachRange(std::size_t count, Body&& body)
{
	tbb::parallel_for(std::size_t(0), (count + kPartsAtOnce - 1) / kPartsAtOnce,
	                  [&](std::size_t r) { body(r, r * kPartsAtOnce, std::min((r + 1) * kPartsAtOnce, count)); });
}

/// Appends lists one after the other.
template <class T>
void appendAll(std::vector<T>& all, const std::vector<std::vector<T>>& lists)
{
	std::vector<std::size_t> starts{all.size()};
	for (const std::vector<T>& list : lists)
		starts.push_back(starts.back() + list.size());
	all.resize(starts.back());
	tbb::parallel_for(std::size_t(0), lists.size(),
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

/// Finds, or makes, the edges that parts do not know yet.
void ShapeRefiner::findEdges()
{
	std::vector<Requests> requests((parts_.size() + kPartsAtOnce - 1) / kPartsAtOnce);
	forEachRange(parts_.size(),
	             [&](std::size_t r, std::size_t begin, std::size_t end) { gather(begin, end, requests[r]); });
	std::array<std::vector<double>, EdgeTable::kShards> middles;
	tbb::parallel_for(std::size_t(0), EdgeTable::kShards,
	                  [&](std::size_t shard)
	                  {
		                  number(shard, requests);
		                  evaluate(shard, middles[shard]);
	                  });
	std::array<std::size_t, EdgeTable::kShards> starts;
	std::size_t count = points_.size();
	for (std::size_t shard = 0; shard < EdgeTable::kShards; ++shard)
	{
		starts[shard] = count;
		count += middles[shard].size() / cells_.width();
	}
	if (count > 8 * kMaxParts)
		throw TooManyParts("too many points");
	points_.resize(count);
	numbers_.resize(count * cells_.width());
	tbb::parallel_for(std::size_t(0), EdgeTable::kShards,
	                  [&](std::size_t s)
	                  {
		                  std::ranges::copy(middles[s],
		                                    numbers_.begin() + static_cast<std::ptrdiff_t>(starts[s] * cells_.width()));
		                  EdgeTable::Shard& shard = edges_.shard(s);
		                  for (const EdgeTable::NewEdge& edge : shard.made)
		                  {
			                  if (edge.point == EdgeTable::kUnknown)
				                  continue;
			                  const auto point = static_cast<std::uint32_t>(starts[s] + edge.point);
			                  shard.edges[edge.number].point = point;
			                  points_[point] = {Vec3(0.0), 0.5 * (Vec3(edge.places[0]) + Vec3(edge.places[1])),
			                                    cells_[edge.near].cell, edge.ends};
		                  }
		                  shard.made.clear();
	                  });
}

void ShapeRefiner::gather(std::size_t begin, std::size_t end, Requests& requests) const
{
	for (std::size_t p = begin; p < end; ++p)
	{
		const Part& part = parts_[p];
		const NearCell& near = cells_[part.near];
		for (std::uint8_t e = 0; e < 6; ++e)
		{
			if (part.edges[e] != EdgeTable::kUnknown)
				continue;
			const auto [a, b] = kEdges[e];
			const std::uint64_t key = EdgeTable::keyOf(part.points[a], part.points[b]);
			const double size = near.sizeOf(near.kind->supportOf(0.5f * (part.places[a] + part.places[b])));
			requests[EdgeTable::shardOf(key)].push_back(
			    {key, static_cast<std::uint32_t>(p), e,
			     !near.is_flat && static_cast<int>(part.level) < near.kind->leastLevels(),
			     std::max(kShareOfEdge * curved_.tolerance * size, least_)});
		}
	}
}

/// Gives numbers to the edges of a shard. The first part that asks has its cell compute the middle, and the cell that
/// allows least says how far it may be off.
void ShapeRefiner::number(std::size_t s, const std::vector<Requests>& requests)
{
	EdgeTable::Shard& shard = edges_.shard(s);
	const auto known = static_cast<std::uint32_t>(shard.edges.size());
	for (const Requests& of_range : requests)
		for (const Request& request : of_range[s])
		{
			Part& part = parts_[request.part];
			const auto next = static_cast<std::uint32_t>(shard.edges.size());
			const auto [number, is_new] = shard.numbers.find(request.key, next);
			part.edges[request.edge] = EdgeTable::idOf(s, number);
			if (is_new)
			{
				if (next >= EdgeTable::kMaxNumber)
					throw TooManyParts("too many edges");
				const auto [a, b] = kEdges[request.edge];
				shard.edges.push_back({-1.0, EdgeTable::kUnknown, static_cast<std::uint8_t>(part.level)});
				shard.made.push_back({number,
				                      part.near,
				                      {part.points[a], part.points[b]},
				                      {part.places[a], part.places[b]},
				                      request.allowed,
				                      request.is_forced,
				                      EdgeTable::kUnknown});
			}
			else if (number >= known)
			{
				EdgeTable::NewEdge& made = shard.made[number - known];
				made.allowed = std::min(made.allowed, request.allowed);
				made.is_forced |= request.is_forced;
			}
		}
}

/// Decides which of a shard's new edges are halved; the numbers of their middles go to `middles`.
void ShapeRefiner::evaluate(std::size_t s, std::vector<double>& middles)
{
	EdgeTable::Shard& shard = edges_.shard(s);
	const std::size_t width = cells_.width();
	std::array<double, kMaxLattice> weights;
	std::array<double, 3 + kMaxShownNumbers> middle;
	std::array<double, 3 + kMaxShownNumbers> first;
	std::array<double, 3 + kMaxShownNumbers> second;
	// Whether both ends are where this cell has them.
	const auto isOwn = [&](const EdgeTable::NewEdge& edge)
	{
		const std::uint32_t cell = cells_[edge.near].cell;
		return points_[edge.ends[0]].cell == cell && points_[edge.ends[1]].cell == cell;
	};
	for (EdgeTable::NewEdge& edge : shard.made)
	{
		cells_.evaluate(edge.near, 0.5 * (Vec3(edge.places[0]) + Vec3(edge.places[1])), weights.data(), middle.data());
		if (shard.edges[edge.number].level >= maxLevel(curved_.tolerance))
			continue;
		double off = offOf(edge, numbersOf(edge.ends[0]), numbersOf(edge.ends[1]), middle.data(), weights.data());
		if (off > 1.0 && !isOwn(edge))
		{
			// Cells that disagree about a face would halve it without end: only what the cell itself is off counts.
			cells_.evaluate(edge.near, Vec3(edge.places[0]), weights.data(), first.data());
			cells_.evaluate(edge.near, Vec3(edge.places[1]), weights.data(), second.data());
			off = std::min(off, offOf(edge, first.data(), second.data(), middle.data(), weights.data()));
		}
		if (off <= 1.0 && !edge.is_forced)
			continue;
		// Edges that are halved in any case come after those that are off.
		shard.edges[edge.number].priority = off > 1.0 ? off : 0.5 + 0.25 * off;
		edge.point = static_cast<std::uint32_t>(middles.size() / width);
		middles.insert(middles.end(), middle.begin(), middle.begin() + static_cast<std::ptrdiff_t>(width));
	}
}

/// Returns the squared error of an edge between these ends, as a share of the allowed one. It is measured at the edge's
/// middle, and also at its quarters if the edge may bend both ways.
double ShapeRefiner::offOf(const EdgeTable::NewEdge& edge, const double* a, const double* b, const double* middle,
                           double* weights) const
{
	const auto share = [&](auto&& off)
	{
		const double geometry = (off(0) * off(0) + off(1) * off(1) + off(2) * off(2)) / (edge.allowed * edge.allowed);
		double values = 0.0;
		for (std::size_t i = 3; i < cells_.width(); ++i)
			values += off(i) * off(i);
		values /= kShareOfEdge * kShareOfEdge;
		// Halving what is infinite would have no end.
		return std::max(std::isfinite(geometry) ? geometry : 0.0, std::isfinite(values) ? values : 0.0);
	};
	const auto at_middle = [&](std::size_t i) { return middle[i] - 0.5 * (a[i] + b[i]); };
	double most = share(at_middle);
	// Where the cell may bend both ways along it, the middle alone does not tell.
	const int degree = cells_[edge.near].kind->degreeAlong(edge.places[0], edge.places[1]);
	for (const double along : {0.25, 0.75})
		if (most <= 1.0 && degree > (along < 0.5 ? 2 : 4))
		{
			std::array<double, 3 + kMaxShownNumbers> other;
			cells_.evaluate(edge.near, (1.0 - along) * Vec3(edge.places[0]) + along * Vec3(edge.places[1]), weights,
			                other.data());
			const auto off = [&](std::size_t i) { return other[i] - ((1.0 - along) * a[i] + along * b[i]); };
			const auto unlike = [&](std::size_t i) { return off(i) - 0.75 * at_middle(i); };
			most = std::max({most, share(off), share(unlike) / (kUnlike * kUnlike)});
		}
	return most;
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
	const std::size_t ranges = (parts_.size() + kPartsAtOnce - 1) / kPartsAtOnce;
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
