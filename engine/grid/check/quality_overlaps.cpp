#include "base/parallel_for.h"
#include "grid/cell_places.h"
#include "grid/check/quality.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace vp::grid
{

namespace
{

constexpr std::size_t kSamples = 20000;   // cells a block
constexpr std::size_t kMaxOthers = 16;    // overlapping cells told for each of these
constexpr std::size_t kPairSamples = 500; // cells of either block of a pair

// Bounds for many blocks at one place, whose pairs grow with the square of their number. Fewer samples a pair come
// first, then fewer pairs.
constexpr std::size_t kAllPairSamples = 200000;
constexpr std::size_t kMinPairSamples = 16;
constexpr std::size_t kAllPairCells = 100000000; // in the blocks of the pairs, which are passed over for samples

// Boxes over cells that follow each other, which lie together: unstructured cells run along a Morton curve.
constexpr std::size_t kPatchCells = 16;
constexpr std::size_t kGroupCellPatches = 64;

bool meet(const Box& a, const Box& b)
{
	return glm::all(glm::lessThan(a.lo, b.hi)) && glm::all(glm::lessThan(b.lo, a.hi));
}

template <Grid G>
Box boxOf(const G& grid, CellId cell, CellFaces& faces)
{
	Box box;
	if (grid.shape(cell) != CellShape::polyhedron)
	{
		for (const PointId p : grid.cellPoints(cell))
			box.include(grid.point(p));
		return box;
	}
	grid.cellFaces(cell, faces);
	for (const PointId p : faces.points)
		box.include(grid.point(p));
	return box;
}

bool holds(const Box& box, const Vec3& p)
{
	return glm::all(glm::lessThanEqual(box.lo, p)) && glm::all(glm::lessThanEqual(p, box.hi));
}

class CellBoxes
{
public:
	// Empty where they are not wanted.
	explicit CellBoxes(const Block& block, bool wanted = true) : block_(block)
	{
		if (wanted)
			std::visit([&](const auto& grid) { build(grid); }, block.grid);
	}

	// Calls visit(cell) for the cells whose boxes have room in common with `box`, until it returns false.
	template <class Visit>
	void forEachMeeting(const Box& box, CellFaces& faces, Visit&& visit) const
	{
		if (meet(block_.bounds, box))
			std::visit([&](const auto& grid) { forEachMeetingIn(grid, box, faces, visit); }, block_.grid);
	}

private:
	template <Grid G, class Visit>
	void forEachMeetingIn(const G& grid, const Box& box, CellFaces& faces, Visit& visit) const
	{
		for (std::size_t g = 0; g < groups_.size(); ++g)
		{
			if (!meet(groups_[g], box))
				continue;
			const std::size_t end = std::min(patches_.size(), (g + 1) * kGroupCellPatches);
			for (std::size_t p = g * kGroupCellPatches; p < end; ++p)
			{
				if (!meet(patches_[p], box))
					continue;
				for (std::size_t c = p * kPatchCells; c < std::min(cells_, (p + 1) * kPatchCells); ++c)
					if (meet(boxOf(grid, static_cast<CellId>(c), faces), box) && !visit(static_cast<CellId>(c)))
						return;
			}
		}
	}

	template <Grid G>
	void build(const G& grid)
	{
		cells_ = grid.cellCount();
		patches_.resize((cells_ + kPatchCells - 1) / kPatchCells);
		groups_.resize((patches_.size() + kGroupCellPatches - 1) / kGroupCellPatches);
		tracedFor(std::size_t(0), groups_.size(),
		          [&](std::size_t g)
		          {
			          CellFaces faces;
			          const std::size_t end = std::min(patches_.size(), (g + 1) * kGroupCellPatches);
			          for (std::size_t p = g * kGroupCellPatches; p < end; ++p)
			          {
				          for (std::size_t c = p * kPatchCells; c < std::min(cells_, (p + 1) * kPatchCells); ++c)
				          {
					          patches_[p].include(boxOf(grid, static_cast<CellId>(c), faces));
				          }
				          groups_[g].include(patches_[p]);
			          }
		          });
	}

	const Block& block_;
	std::size_t cells_ = 0;
	std::vector<Box> patches_;
	std::vector<Box> groups_;
};

bool isBoxes(const Block& block)
{
	return std::holds_alternative<UniformGrid>(block.grid) || std::holds_alternative<RectilinearGrid>(block.grid);
}

using Pair = std::pair<SetCell, SetCell>;

struct Scratch
{
	CellFaces faces;
	CellPlaces mine;
	CellPlaces other;
	std::vector<Vec3> points;
};

// Sets the points of a cell that are looked for in others: its center, and points halfway from there to its corners.
template <Grid G>
void choosePoints(const G& grid, CellId cell, Scratch& scratch)
{
	scratch.mine.fetch(grid, cell);
	scratch.points.push_back(scratch.mine.center);
	for (const Vec3& corner : scratch.mine.places)
		if (const Vec3 p = 0.5 * (scratch.mine.center + corner);
		    std::ranges::find(scratch.points, p) == scratch.points.end())
			scratch.points.push_back(p);
	std::erase_if(scratch.points, [&](const Vec3& p) { return !liesInside(scratch.mine, p); });
}

bool holdsAny(const BlockSet& set, const SetCell& cell, Scratch& scratch)
{
	return std::visit(
	    [&](const auto& grid)
	    {
		    const Box box = boxOf(grid, cell.cell, scratch.faces);
		    if (std::ranges::none_of(scratch.points, [&](const Vec3& p) { return holds(box, p); }))
			    return false;
		    scratch.other.fetch(grid, cell.cell);
		    return std::ranges::any_of(scratch.points, [&](const Vec3& p) { return liesInside(scratch.other, p); });
	    },
	    set.blocks[cell.block].grid);
}

// Adds cells, other than `cell` itself, that hold one of its points: up to kMaxOthers, of the blocks that `against`
// names. The search begins with the cell's own block, so that blocks at one place do not all find the same few.
template <Grid G>
void lookAt(const BlockSet& set, const G& grid, const SetCell& cell, std::span<const CellBoxes> boxes,
            std::span<const std::uint32_t> against, Scratch& scratch, std::vector<Pair>& found)
{
	const Box box = boxOf(grid, cell.cell, scratch.faces);
	const std::size_t most = found.size() + kMaxOthers;
	bool has_points = false;
	scratch.points.clear();
	const std::size_t own = std::ranges::lower_bound(against, cell.block) - against.begin();
	for (std::size_t n = 0; n < against.size() && found.size() < most; ++n)
	{
		const std::uint32_t block = against[(own + n) % against.size()];
		boxes[block].forEachMeeting(box, scratch.faces,
		                            [&](CellId other)
		                            {
			                            const SetCell that{block, other};
			                            if (that == cell)
				                            return true;
			                            if (!has_points)
				                            choosePoints(grid, cell.cell, scratch);
			                            has_points = true;
			                            if (holdsAny(set, that, scratch))
				                            found.push_back(std::minmax(cell, that));
			                            return !scratch.points.empty() && found.size() < most;
		                            });
		if (has_points && scratch.points.empty())
			return;
	}
}

// Looks at up to `most` cells of block a that lie within the bounds of b, and counts those that hold a point in common
// with one of b.
void lookBetween(const BlockSet& set, std::uint32_t a, std::uint32_t b, std::span<const CellBoxes> boxes,
                 std::size_t most, BlockOverlap& overlap)
{
	Scratch scratch;
	std::vector<CellId> within;
	boxes[a].forEachMeeting(set.blocks[b].bounds, scratch.faces,
	                        [&](CellId cell)
	                        {
		                        within.push_back(cell);
		                        return true;
	                        });
	std::vector<Pair> found;
	const std::size_t samples = std::min(most, within.size());
	for (std::size_t s = 0; s < samples; ++s)
	{
		found.clear();
		const SetCell cell{a, within[s * within.size() / samples]};
		std::visit([&](const auto& grid) { lookAt(set, grid, cell, boxes, std::span(&b, 1), scratch, found); },
		           set.blocks[a].grid);
		overlap.cells += !found.empty();
	}
	overlap.samples += samples;
}

// Calls visit(a, b) for the pairs of blocks whose bounds have room in common.
template <class Visit>
void forEachMeetingPair(const BlockSet& set, Visit&& visit)
{
	for (std::uint32_t a = 0; a < set.blocks.size(); ++a)
		for (std::uint32_t b = a + 1; b < set.blocks.size(); ++b)
			if (meet(set.blocks[a].bounds, set.blocks[b].bounds))
				visit(a, b);
}

std::size_t cellCount(const Block& block)
{
	return std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid);
}

} // namespace

BlockOverlaps findBlockOverlaps(const BlockSet& set)
{
	BlockOverlaps found;
	std::size_t cells = 0;
	forEachMeetingPair(set,
	                   [&](std::uint32_t a, std::uint32_t b)
	                   {
		                   ++found.near;
		                   cells += cellCount(set.blocks[a]) + cellCount(set.blocks[b]);
	                   });
	const std::size_t step = std::max(found.near / (kAllPairSamples / (2 * kMinPairSamples)),
	                                  cells / std::max(kAllPairCells, 16 * set.cellCount())) +
	                         1;
	std::vector<bool> wanted(set.blocks.size(), false);
	std::size_t number = 0;
	forEachMeetingPair(set,
	                   [&](std::uint32_t a, std::uint32_t b)
	                   {
		                   if (number++ % step != 0)
			                   return;
		                   found.pairs.push_back({a, b, 0, 0});
		                   wanted[a] = wanted[b] = true;
	                   });
	found.looked_at = found.pairs.size();
	if (found.pairs.empty())
		return found;
	const std::size_t most = std::clamp(kAllPairSamples / (2 * found.looked_at), kMinPairSamples, kPairSamples);
	std::vector<CellBoxes> boxes;
	boxes.reserve(set.blocks.size());
	for (std::size_t b = 0; b < set.blocks.size(); ++b)
		boxes.emplace_back(set.blocks[b], wanted[b]);
	tracedFor(std::size_t(0), found.pairs.size(),
	          [&](std::size_t p)
	          {
		          BlockOverlap& pair = found.pairs[p];
		          lookBetween(set, pair.a, pair.b, boxes, most, pair);
		          lookBetween(set, pair.b, pair.a, boxes, most, pair);
	          });
	std::erase_if(found.pairs, [](const BlockOverlap& pair) { return pair.cells == 0; });
	return found;
}

void findOverlaps(const BlockSet& set, Quality& quality)
{
	if (std::ranges::all_of(set.blocks, isBoxes) && set.blocks.size() < 2)
		return;
	std::vector<CellBoxes> boxes;
	boxes.reserve(set.blocks.size());
	for (const Block& block : set.blocks)
		boxes.emplace_back(block);
	tbb::combinable<std::vector<Pair>> found;
	for (std::uint32_t b = 0; b < set.blocks.size(); ++b)
	{
		const Block& block = set.blocks[b];
		std::vector<std::uint32_t> against;
		for (std::uint32_t o = 0; o < set.blocks.size(); ++o)
			if (o == b ? !isBoxes(block) : meet(block.bounds, set.blocks[o].bounds))
				against.push_back(o); // ascending
		if (against.empty())
			continue;
		std::visit(
		    [&](const auto& grid)
		    {
			    const std::size_t samples = std::min(kSamples, grid.cellCount());
			    quality.overlap_samples += samples;
			    tracedFor(tbb::blocked_range<std::size_t>(0, samples, 64),
			              [&](const auto& range)
			              {
				              Scratch scratch;
				              for (std::size_t s = range.begin(); s < range.end(); ++s)
					              lookAt(set, grid, SetCell{b, static_cast<CellId>(s * grid.cellCount() / samples)},
					                     boxes, against, scratch, found.local());
			              });
		    },
		    block.grid);
	}
	found.combine_each([&](const std::vector<Pair>& some)
	                   { quality.overlaps.insert(quality.overlaps.end(), some.begin(), some.end()); });
	std::ranges::sort(quality.overlaps);
	quality.overlaps.erase(std::unique(quality.overlaps.begin(), quality.overlaps.end()), quality.overlaps.end());
}

} // namespace vp::grid
