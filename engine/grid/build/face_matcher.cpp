#include "grid/build/face_matcher.h"

#include "base/parallel_for.h"
#include "grid/build/face_corners.h"
#include "grid/build/hanging_faces.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::grid
{

namespace
{

constexpr double kEdgeTolerance = 1e-6;
constexpr double kUlps = 4.0;
constexpr double kMaxOfAnEdge = 0.25;

struct Candidate
{
	Vec3 center;
	double edge;      // the shortest
	double tolerance; // of a corner
	double most; // what no tolerance may pass: a cell may be flatter, and must not meet what lies on its other side
	std::uint32_t block;
	BoundaryIndex::Face face;
};

double storedUlp(const UniformGrid&)
{
	return std::numeric_limits<double>::epsilon();
}

double storedUlp(const RectilinearGrid&)
{
	return std::numeric_limits<double>::epsilon();
}

template <class G>
double storedUlp(const G& grid)
{
	return grid.coordinates().isDouble() ? std::numeric_limits<double>::epsilon()
	                                     : std::numeric_limits<float>::epsilon();
}

// The shortest edge of the cell whose faces these are; edges without length left out. Infinite where it has none.
template <Grid G>
double shortestEdge(const G& grid, const CellFaces& faces)
{
	double shortest = std::numeric_limits<double>::infinity();
	for (int f = 0; f < faces.size(); ++f)
	{
		Vec3 previous = grid.point(faces[f].back());
		for (const PointId p : faces[f])
		{
			const Vec3 corner = grid.point(p);
			if (const double length = glm::length(corner - previous); length > 0.0)
				shortest = std::min(shortest, length);
			previous = corner;
		}
	}
	return shortest;
}

template <Grid G>
bool describe(const G& grid, std::uint32_t block, const BoundaryIndex::Face& face, CellFaces& faces,
              std::vector<Vec3>& points, Candidate& candidate)
{
	faceCorners(grid, face, faces, points);
	if (points.size() < 3)
		return false;
	Vec3 sum(0.0);
	Vec3 greatest(0.0);
	double edge = std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		sum += points[i];
		greatest = glm::max(greatest, glm::abs(points[i]));
		edge = std::min(edge, glm::length(points[i] - points[i ? i - 1 : points.size() - 1]));
	}
	const double floor = kUlps * storedUlp(grid) * std::max({greatest.x, greatest.y, greatest.z});
	const double tolerance = std::max(kEdgeTolerance * edge, std::min(floor, kMaxOfAnEdge * edge));
	const double most = kMaxOfAnEdge * shortestEdge(grid, faces);
	candidate = {sum / static_cast<double>(points.size()), edge, tolerance, most, block, face};
	return std::isfinite(candidate.center.x) && std::isfinite(candidate.center.y) &&
	       std::isfinite(candidate.center.z) && edge > 0.0;
}

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
		tbb::combinable<std::vector<std::pair<std::uint32_t, SeamLink>>> found;
		parallelFor(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(candidates_.size()), 1024),
		            [&](const auto& range)
		            {
			            Scratch scratch;
			            auto& mine = found.local();
			            for (std::uint32_t i = range.begin(); i < range.end(); ++i)
				            matchOne(i, scratch, mine);
		            });
		std::vector<std::vector<SeamLink>> links(set_.blocks.size());
		// A candidate finds the matches that come after it, so it may not know that it has one.
		std::vector<std::vector<BoundaryIndex::Face>> matched(set_.blocks.size());
		found.combine_each(
		    [&](const auto& some)
		    {
			    for (const auto& [block, link] : some)
			    {
				    links[block].push_back(link);
				    matched[block].push_back({link.cell, link.face});
			    }
		    });
		for (auto& of_block : matched)
			std::ranges::sort(of_block, {}, placeOf);
		std::vector<LooseFace> loose;
		for (const Candidate& c : candidates_)
			if (!std::ranges::binary_search(matched[c.block], placeOf(c.face), {}, placeOf))
				loose.push_back({c.block, c.face, c.tolerance, c.most});
		linkHangingFaces(set_, loose, links);
		return links;
	}

private:
	static std::pair<CellId, std::uint32_t> placeOf(const BoundaryIndex::Face& face) { return {face.cell, face.face}; }

	struct Scratch
	{
		CellFaces faces;
		std::vector<Vec3> mine;
		std::vector<Vec3> other;
		std::vector<std::uint64_t> buckets;
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
		const double reach = 2.0 * c.tolerance;
		const int low = levelOf(std::max(c.edge - 2.0 * reach, 0.5 * c.edge));
		const int high = levelOf(c.edge + 2.0 * reach);
		for (int level = low; level <= high; ++level)
			for (int corner = 0; corner < 8; ++corner)
				buckets.push_back(
				    bucketOf(level, c.center + Vec3(corner & 1 ? reach : -reach, corner & 2 ? reach : -reach,
				                                    corner & 4 ? reach : -reach)));
		std::ranges::sort(buckets);
		buckets.erase(std::unique(buckets.begin(), buckets.end()), buckets.end());
	}

	// Links the candidate with the matches that come after it.
	void matchOne(std::uint32_t i, Scratch& scratch, std::vector<std::pair<std::uint32_t, SeamLink>>& found) const
	{
		const Candidate& a = candidates_[i];
		scratch.mine.clear();
		bucketsAround(a, scratch.buckets);
		for (const std::uint64_t bucket : scratch.buckets)
			for (auto at = std::upper_bound(sorted_.begin(), sorted_.end(), std::pair(bucket, i));
			     at != sorted_.end() && at->first == bucket; ++at)
			{
				const Candidate& b = candidates_[at->second];
				if (!mayMatch(a, b))
					continue;
				if (scratch.mine.empty())
					cornersOf(a, scratch.faces, scratch.mine);
				cornersOf(b, scratch.faces, scratch.other);
				if (!coincide(scratch.mine, scratch.other, toleranceOf(a, b)))
					continue;
				found.push_back({a.block, {a.face.cell, a.face.face, b.block, b.face.cell, b.face.face}});
				found.push_back({b.block, {b.face.cell, b.face.face, a.block, a.face.cell, a.face.face}});
			}
	}

	// A cell does not meet itself. The mean of corners rounds in their order.
	bool mayMatch(const Candidate& a, const Candidate& b) const
	{
		if (a.block == b.block && (a.face.cell == b.face.cell || !meetsItself(set_.blocks[a.block].grid)))
			return false;
		return glm::length(a.center - b.center) <= 2.0 * toleranceOf(a, b);
	}
	static double toleranceOf(const Candidate& a, const Candidate& b)
	{
		return std::min({std::max(a.tolerance, b.tolerance), a.most, b.most});
	}

	void cornersOf(const Candidate& c, CellFaces& faces, std::vector<Vec3>& points) const
	{
		std::visit([&](const auto& grid) { faceCorners(grid, c.face, faces, points); }, set_.blocks[c.block].grid);
	}

	static bool coincide(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance)
	{
		return a.size() == b.size() &&
		       std::ranges::all_of(
		           a, [&](const Vec3& p)
		           { return std::ranges::any_of(b, [&](const Vec3& q) { return glm::length(p - q) <= tolerance; }); });
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
