#include "grid/link/hanging_faces.h"

#include "base/parallel_for.h"
#include "grid/link/face_corners.h"
#include "grid/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace vp::grid
{

namespace
{

constexpr double kSmaller = 0.95; // largest area of a smaller face, as a share of the larger one's

struct Outline
{
	Box box;
	double extent = 0.0; // the box's longest side
};

class HangingMatcher
{
public:
	HangingMatcher(const BlockSet& set, std::span<const LooseFace> faces) : set_(set), faces_(faces) {}

	void link(std::vector<std::vector<SeamLink>>& links)
	{
		outline();
		sortIntoBuckets();
		tbb::combinable<std::vector<std::pair<std::uint32_t, SeamLink>>> found;
		parallelFor(tbb::blocked_range<std::size_t>(0, faces_.size(), 1024),
		            [&](const auto& range)
		            {
			            Scratch scratch;
			            auto& mine = found.local();
			            for (std::size_t i = range.begin(); i < range.end(); ++i)
				            matchOne(static_cast<std::uint32_t>(i), scratch, mine);
		            });
		found.combine_each(
		    [&](const auto& some)
		    {
			    for (const auto& [block, link] : some)
				    links[block].push_back(link);
		    });
	}

private:
	struct Scratch
	{
		CellFaces faces;
		std::vector<Vec3> small;
		std::vector<Vec3> large;
	};

	void corners(const LooseFace& of, CellFaces& faces, std::vector<Vec3>& points) const
	{
		std::visit([&](const auto& grid) { faceCorners(grid, of.face, faces, points); }, set_.blocks[of.block].grid);
	}

	void outline()
	{
		outlines_.resize(faces_.size());
		parallelFor(tbb::blocked_range<std::size_t>(0, faces_.size(), 1024),
		            [&](const auto& range)
		            {
			            Scratch scratch;
			            for (std::size_t i = range.begin(); i < range.end(); ++i)
			            {
				            corners(faces_[i], scratch.faces, scratch.small);
				            for (const Vec3& corner : scratch.small)
					            outlines_[i].box.include(corner);
				            const Vec3 size = outlines_[i].box.size();
				            outlines_[i].extent = std::max({size.x, size.y, size.z});
			            }
		            });
	}

	// The width of the cubes for faces of this extent: more than it, so that a face lies in two along each axis at
	// most.
	static int levelOf(double extent) { return std::ilogb(extent) + 1; }

	// A face stands in the bucket of every cube that it reaches into.
	void sortIntoBuckets()
	{
		for (std::uint32_t i = 0; i < faces_.size(); ++i)
		{
			const int level = levelOf(outlines_[i].extent);
			if (const auto at = std::ranges::lower_bound(levels_, level); at == levels_.end() || *at != level)
				levels_.insert(at, level);
			const Vec3 slack = faces_[i].tolerance.corner;
			const Vec3 lo = outlines_[i].box.lo - slack;
			const Vec3 hi = outlines_[i].box.hi + slack;
			const std::size_t first = sorted_.size();
			for (int corner = 0; corner < 8; ++corner)
			{
				const Vec3 at(corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z);
				const std::pair entry(bucketOf(level, at), i);
				if (std::find(sorted_.begin() + static_cast<std::ptrdiff_t>(first), sorted_.end(), entry) ==
				    sorted_.end())
					sorted_.push_back(entry);
			}
		}
		tbb::parallel_sort(sorted_);
		// Where the buckets begin whose numbers begin with the same bits.
		bits_ = std::max(1, static_cast<int>(std::bit_width(sorted_.size())) - 1);
		starts_.assign((std::size_t(1) << bits_) + 1, 0);
		for (const auto& [number, face] : sorted_)
			++starts_[(number >> (64 - bits_)) + 1];
		std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
	}

	// Links the face with all larger ones that it lies in.
	void matchOne(std::uint32_t i, Scratch& scratch, std::vector<std::pair<std::uint32_t, SeamLink>>& found) const
	{
		const LooseFace& small = faces_[i];
		const Vec3 center = outlines_[i].box.center();
		bool has_corners = false;
		// A face may be as long as one of its parts.
		const int least =
		    levelOf(std::max(outlines_[i].extent - 2.0 * small.tolerance.greatest(), 0.5 * outlines_[i].extent));
		for (auto level = std::ranges::lower_bound(levels_, least); level != levels_.end(); ++level)
		{
			const std::uint64_t bucket = bucketOf(*level, center);
			const std::size_t head = bucket >> (64 - bits_);
			for (std::size_t at = starts_[head]; at < starts_[head + 1]; ++at)
			{
				if (sorted_[at].first != bucket || !mayHold(sorted_[at].second, i))
					continue;
				const LooseFace& large = faces_[sorted_[at].second];
				if (!has_corners)
					corners(small, scratch.faces, scratch.small);
				has_corners = true;
				corners(large, scratch.faces, scratch.large);
				if (!liesIn(small, scratch.small, large, scratch.large))
					continue;
				const auto& [cell, face] = small.face;
				const auto& [other, other_face] = large.face;
				found.push_back({small.block, {cell, face, large.block, other, other_face, Hang::small}});
				found.push_back({large.block, {other, other_face, small.block, cell, face, Hang::large}});
			}
		}
	}

	bool mayHold(std::uint32_t l, std::uint32_t s) const
	{
		const LooseFace& large = faces_[l];
		const LooseFace& small = faces_[s];
		if (large.block == small.block &&
		    (large.face.cell == small.face.cell || !meetsItself(set_.blocks[large.block].grid)))
			return false;
		const Vec3 slack = glm::max(large.tolerance.corner, small.tolerance.corner);
		return glm::all(glm::greaterThanEqual(outlines_[s].box.lo, outlines_[l].box.lo - slack)) &&
		       glm::all(glm::lessThanEqual(outlines_[s].box.hi, outlines_[l].box.hi + slack));
	}

	bool liesIn(const LooseFace& small, const std::vector<Vec3>& part, const LooseFace& large,
	            const std::vector<Vec3>& whole) const
	{
		const auto areaOf = [](const std::vector<Vec3>& points)
		{ return polygonArea(points.size(), [&](std::size_t i) { return points[i]; }); };
		const Vec3 area = areaOf(whole);
		const double size = glm::length(area);
		if (!(size > 0.0) || glm::length(areaOf(part)) > kSmaller * size)
			return false;
		const Vec3 normal = area / size;
		Vec3 middle(0.0);
		for (const Vec3& corner : whole)
			middle += corner / static_cast<double>(whole.size());
		double warp = 0.0;
		for (const Vec3& corner : whole)
			warp = std::max(warp, std::abs(glm::dot(corner - middle, normal)));

		const Vec3 tolerance = toleranceBetween(small.tolerance, large.tolerance);
		const auto toleranceAlong = [&](const Vec3& direction) { return glm::dot(glm::abs(direction), tolerance); };
		for (const Vec3& corner : part)
		{
			if (std::abs(glm::dot(corner - middle, normal)) > toleranceAlong(normal) + warp)
				return false;
			for (std::size_t e = 0; e < whole.size(); ++e)
			{
				const Vec3 along = whole[(e + 1) % whole.size()] - whole[e];
				const Vec3 inward = glm::cross(normal, along);
				if (glm::dot(inward, corner - whole[e]) < -toleranceAlong(inward))
					return false;
			}
		}
		return glm::dot(cellMiddle(small) - middle, normal) * glm::dot(cellMiddle(large) - middle, normal) < 0.0;
	}

	Vec3 cellMiddle(const LooseFace& of) const
	{
		return std::visit(
		    [&](const auto& grid)
		    {
			    CellFaces faces;
			    grid.cellFaces(of.face.cell, faces);
			    Vec3 sum(0.0);
			    double count = 0.0;
			    for (int f = 0; f < faces.size(); ++f)
				    for (const PointId p : faces[f])
				    {
					    sum += grid.point(p);
					    ++count;
				    }
			    return sum / count;
		    },
		    set_.blocks[of.block].grid);
	}

	const BlockSet& set_;
	std::span<const LooseFace> faces_;
	std::vector<Outline> outlines_;
	std::vector<int> levels_;                                     // that occur, ascending
	std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_; // bucket, face
	std::vector<std::uint32_t> starts_;
	int bits_ = 1;
};

} // namespace

void linkHangingFaces(const BlockSet& blocks, std::span<const LooseFace> faces,
                      std::vector<std::vector<SeamLink>>& links)
{
	if (!faces.empty())
		HangingMatcher(blocks, faces).link(links);
}

} // namespace vp::grid
