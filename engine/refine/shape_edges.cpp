#include "base/parallel_for.h"
#include "refine/part_ranges.h"
#include "refine/shape_refiner.h"
#include "refine/tetrahedron.h"

#include <algorithm>
#include <cmath>

namespace vp::refine
{

namespace
{

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

} // namespace

/// Finds, or makes, the edges that parts do not know yet.
void ShapeRefiner::findEdges()
{
	std::vector<Requests> requests(rangesOf(parts_.size()));
	forEachRange(parts_.size(),
	             [&](std::size_t r, std::size_t begin, std::size_t end) { gather(begin, end, requests[r]); });
	std::array<std::vector<double>, EdgeTable::kShards> middles;
	tracedFor(std::size_t(0), EdgeTable::kShards,
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
	tracedFor(std::size_t(0), EdgeTable::kShards,
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

} // namespace vp::refine
