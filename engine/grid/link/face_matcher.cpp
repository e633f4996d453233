#include "grid/link/face_matcher.h"

#include "base/parallel_for.h"
#include "grid/face_tolerance.h"
#include "grid/link/face_corners.h"
#include "grid/link/hanging_faces.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vp::grid
{

namespace
{

// Up to so many faces at one place are linked to all others there. In a larger crowd (one file given hundreds of times)
// each is linked to the next two and the two before. This still leads to all, and the lowest face has two others, by
// which vprobe check tells that more than two cells meet.
constexpr std::size_t kMaxFacesLinked = 8;
constexpr std::size_t kLinkedInCrowd = 2;

struct Candidate
{
	Vec3 center;
	double edge; // the shortest
	FaceTolerance tolerance;
	std::uint32_t block;
	BoundaryIndex::Face face;
};

template <Grid G>
bool describe(const G& grid, std::uint32_t block, const BoundaryIndex::Face& face, CellFaces& faces,
              std::vector<Vec3>& points, Candidate& candidate)
{
	faceCorners(grid, face, faces, points);
	if (points.size() < 3)
		return false;
	Vec3 sum(0.0);
	double edge = std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		sum += points[i];
		edge = std::min(edge, glm::length(points[i] - points[i ? i - 1 : points.size() - 1]));
	}
	candidate = {sum / static_cast<double>(points.size()), edge,
	             toleranceOf(grid, faces, static_cast<int>(face.face), points), block, face};
	return std::isfinite(candidate.center.x) && std::isfinite(candidate.center.y) &&
	       std::isfinite(candidate.center.z) && edge > 0.0;
}

// Two candidates whose corners are the same places.
struct Match
{
	std::uint32_t a;
	std::uint32_t b;
	bool apart; // some corners are not equal, only within the tolerance

	auto operator<=>(const Match&) const = default;
};

// Faces whose shortest edge and center are alike share a bucket, so near-wall faces do not crowd in one.
int levelOf(double edge)
{
	return std::ilogb(edge);
}

class Matcher
{
public:
	Matcher(const BlockSet& set, const FacesOfBlocks& faces) : set_(set), faces_(faces) {}

	std::vector<std::vector<SeamLink>> links()
	{
		collect();
		sortIntoBuckets();
		std::vector<std::vector<SeamLink>> links(set_.blocks.size());
		std::vector<bool> is_matched(candidates_.size());
		for (const Match& match : withoutClosing(matches()))
		{
			const Candidate& a = candidates_[match.a];
			const Candidate& b = candidates_[match.b];
			links[a.block].push_back({a.face.cell, a.face.face, b.block, b.face.cell, b.face.face});
			links[b.block].push_back({b.face.cell, b.face.face, a.block, a.face.cell, a.face.face});
			is_matched[match.a] = is_matched[match.b] = true;
		}
		std::vector<LooseFace> loose;
		for (std::size_t i = 0; i < candidates_.size(); ++i)
			if (!is_matched[i])
				loose.push_back({candidates_[i].block, candidates_[i].face, candidates_[i].tolerance});
		linkHangingFaces(set_, loose, links);
		return links;
	}

private:
	struct Scratch
	{
		CellFaces faces;
		std::vector<Vec3> mine;
		std::vector<Vec3> other;
		std::vector<std::uint64_t> buckets;
		std::vector<std::uint32_t> near;
	};

	// Boundary faces that may lie on another: all of a block that may meet itself, else those within another block's
	// bounds.
	void collect()
	{
		for (std::uint32_t b = 0; b < set_.blocks.size(); ++b)
		{
			const Block& block = set_.blocks[b];
			std::vector<Box> others;
			if (!meetsItself(block.grid))
			{
				for (std::uint32_t o = 0; o < set_.blocks.size(); ++o)
					if (o != b && touch(block.bounds, set_.blocks[o].bounds))
						others.push_back(set_.blocks[o].bounds);
				if (others.empty())
					continue;
			}
			const std::span<const BoundaryIndex::Face> faces = faces_[b];
			std::vector<Candidate> all(faces.size());
			std::vector<std::uint8_t> kept(faces.size());
			std::visit(
			    [&](const auto& grid)
			    {
				    parallelFor(tbb::blocked_range<std::size_t>(0, faces.size(), 1024),
				                [&](const auto& range)
				                {
					                Scratch scratch;
					                for (std::size_t i = range.begin(); i < range.end(); ++i)
						                kept[i] = describe(grid, b, faces[i], scratch.faces, scratch.mine, all[i]) &&
						                          (others.empty() || nearAny(others, all[i]));
				                });
			    },
			    block.grid);
			for (std::size_t i = 0; i < faces.size(); ++i)
				if (kept[i])
					candidates_.push_back(all[i]);
		}
	}

	static bool touch(const Box& a, const Box& b)
	{
		const Vec3 slack(1e-5 * std::max(a.diagonal(), b.diagonal()));
		return glm::all(glm::lessThanEqual(a.lo, b.hi + slack)) && glm::all(glm::lessThanEqual(b.lo, a.hi + slack));
	}
	static bool nearAny(const std::vector<Box>& boxes, const Candidate& c)
	{
		return std::ranges::any_of(boxes,
		                           [&](const Box& box)
		                           {
			                           return glm::all(glm::greaterThanEqual(c.center, box.lo - c.edge)) &&
			                                  glm::all(glm::lessThanEqual(c.center, box.hi + c.edge));
		                           });
	}

	void sortIntoBuckets()
	{
		sorted_.resize(candidates_.size());
		parallelFor(std::size_t(0), candidates_.size(),
		            [&](std::size_t i)
		            {
			            const Candidate& c = candidates_[i];
			            sorted_[i] = {bucketOf(levelOf(c.edge), c.center), static_cast<std::uint32_t>(i)};
		            });
		tbb::parallel_sort(sorted_);
	}

	// Every bucket in which a match of the candidate may lie: nearly always its own.
	void bucketsAround(const Candidate& c, std::vector<std::uint64_t>& buckets) const
	{
		buckets.clear();
		const Vec3 reach = 2.0 * c.tolerance.corner;
		const double longer = 2.0 * glm::length(reach);
		const int low = levelOf(std::max(c.edge - longer, 0.5 * c.edge));
		const int high = levelOf(c.edge + longer);
		for (int level = low; level <= high; ++level)
			for (int corner = 0; corner < 8; ++corner)
				buckets.push_back(
				    bucketOf(level, c.center + Vec3(corner & 1 ? reach.x : -reach.x, corner & 2 ? reach.y : -reach.y,
				                                    corner & 4 ? reach.z : -reach.z)));
		std::ranges::sort(buckets);
		buckets.erase(std::unique(buckets.begin(), buckets.end()), buckets.end());
	}

	// All matches, ascending. A candidate finds those that come after it.
	std::vector<Match> matches() const
	{
		tbb::combinable<std::vector<Match>> found;
		parallelFor(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(candidates_.size()), 1024),
		            [&](const auto& range)
		            {
			            Scratch scratch;
			            std::vector<Match>& mine = found.local();
			            for (std::uint32_t i = range.begin(); i < range.end(); ++i)
				            matchOne(i, scratch, mine);
		            });
		std::vector<Match> all;
		found.combine_each([&](const std::vector<Match>& some) { all.insert(all.end(), some.begin(), some.end()); });
		std::ranges::sort(all);
		return all;
	}

	// Matches the candidate with those that come after it, or, in a crowd, with the next of them.
	void matchOne(std::uint32_t i, Scratch& scratch, std::vector<Match>& found) const
	{
		scratch.mine.clear();
		bucketsAround(candidates_[i], scratch.buckets);
		for (const std::uint64_t bucket : scratch.buckets)
		{
			auto at = std::upper_bound(sorted_.begin(), sorted_.end(), std::pair(bucket, i));
			scratch.near.clear();
			for (; at != sorted_.end() && at->first == bucket && scratch.near.size() <= kMaxFacesLinked; ++at)
				if (mayMatch(candidates_[i], candidates_[at->second]))
					scratch.near.push_back(at->second);
			std::size_t links = scratch.near.size() > kMaxFacesLinked ? kLinkedInCrowd : kMaxFacesLinked;
			for (const std::uint32_t other : scratch.near)
				if (links > 0)
					links -= addIfMatch(i, other, scratch, found);
			for (; links > 0 && at != sorted_.end() && at->first == bucket; ++at)
				if (mayMatch(candidates_[i], candidates_[at->second]))
					links -= addIfMatch(i, at->second, scratch, found);
		}
	}

	bool addIfMatch(std::uint32_t i, std::uint32_t j, Scratch& scratch, std::vector<Match>& found) const
	{
		const Candidate& a = candidates_[i];
		const Candidate& b = candidates_[j];
		if (scratch.mine.empty())
			cornersOf(a, scratch.faces, scratch.mine);
		cornersOf(b, scratch.faces, scratch.other);
		if (!coincide(scratch.mine, scratch.other, toleranceBetween(a.tolerance, b.tolerance)))
			return false;
		found.push_back({i, j, !coincide(scratch.mine, scratch.other, Vec3(0.0))});
		return true;
	}

	// A cell does not meet itself. The mean of corners rounds in their order.
	bool mayMatch(const Candidate& a, const Candidate& b) const
	{
		if (a.block == b.block && (a.face.cell == b.face.cell || !meetsItself(set_.blocks[a.block].grid)))
			return false;
		return areOnePlace(a.center, b.center, 2.0 * toleranceBetween(a.tolerance, b.tolerance));
	}

	// Leaves out matches of faces that lie on either side of a cell thinner than the tolerance: it would be closed.
	std::vector<Match> withoutClosing(std::vector<Match> all) const
	{
		if (std::ranges::none_of(all, &Match::apart))
			return all;
		using Pair = std::pair<std::uint32_t, std::uint32_t>;
		std::vector<Pair> others; // pairs of a candidate and what it matches
		for (const Match& match : all)
		{
			others.emplace_back(match.a, match.b);
			others.emplace_back(match.b, match.a);
		}
		std::ranges::sort(others);
		const auto matchesOf = [&](std::uint32_t i)
		{
			const auto begin = std::ranges::lower_bound(others, i, {}, &Pair::first);
			return std::span(begin, std::ranges::upper_bound(others, i, {}, &Pair::first));
		};
		const auto areSidesOfOneCell = [&](const Candidate& a, const Candidate& b)
		{ return a.block == b.block && a.face.cell == b.face.cell && a.face.face != b.face.face; };
		std::erase_if(all,
		              [&](const Match& match)
		              {
			              if (!match.apart)
				              return false;
			              for (const auto& [a, at_a] : matchesOf(match.a))
				              for (const auto& [b, at_b] : matchesOf(match.b))
					              if (areSidesOfOneCell(candidates_[at_a], candidates_[at_b]))
						              return true;
			              return false;
		              });
		return all;
	}

	void cornersOf(const Candidate& c, CellFaces& faces, std::vector<Vec3>& points) const
	{
		std::visit([&](const auto& grid) { faceCorners(grid, c.face, faces, points); }, set_.blocks[c.block].grid);
	}

	static bool coincide(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const Vec3& tolerance)
	{
		return a.size() == b.size() &&
		       std::ranges::all_of(
		           a, [&](const Vec3& p)
		           { return std::ranges::any_of(b, [&](const Vec3& q) { return areOnePlace(p, q, tolerance); }); });
	}

	const BlockSet& set_;
	const FacesOfBlocks& faces_;
	std::vector<Candidate> candidates_;
	std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_; // bucket, candidate
};

} // namespace

std::vector<std::vector<SeamLink>> matchFaces(const BlockSet& blocks, const FacesOfBlocks& faces)
{
	return Matcher(blocks, faces).links();
}

} // namespace vp::grid
