#include "grid/cell_places.h"
#include "grid/check/quality.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace vp::grid
{

namespace
{

constexpr std::size_t kSamples = 20000;   // cells a block
constexpr std::size_t kPairSamples = 500; // cells of either block of a pair

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

	// Adds the cells whose boxes have room in common with `box`.
	void addMeeting(const Box& box, std::uint32_t block, CellPlaces& scratch, std::vector<SetCell>& cells) const
	{
		if (!meet(block_.bounds, box))
			return;
		std::visit(
		    [&](const auto& grid)
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
						    if (meet(boxOf(grid, static_cast<CellId>(c), scratch.faces), box))
							    cells.push_back({block, static_cast<CellId>(c)});
				    }
			    }
		    },
		    block_.grid);
	}

private:
	template <Grid G>
	void build(const G& grid)
	{
		cells_ = grid.cellCount();
		patches_.resize((cells_ + kPatchCells - 1) / kPatchCells);
		groups_.resize((patches_.size() + kGroupCellPatches - 1) / kGroupCellPatches);
		tbb::parallel_for(std::size_t(0), groups_.size(),
		                  [&](std::size_t g)
		                  {
			                  CellFaces faces;
			                  const std::size_t end = std::min(patches_.size(), (g + 1) * kGroupCellPatches);
			                  for (std::size_t p = g * kGroupCellPatches; p < end; ++p)
			                  {
				                  for (std::size_t c = p * kPatchCells; c < std::min(cells_, (p + 1) * kPatchCells);
				                       ++c)
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
	CellPlaces mine;
	CellPlaces other;
	std::vector<SetCell> near;
	std::vector<Vec3> points;
};

// The cells, other than `cell` itself, that hold one of its points: its center, and points halfway from there to its
// corners.
template <Grid G>
void lookAt(const BlockSet& set, const G& grid, const SetCell& cell, std::span<const CellBoxes> boxes,
            const std::vector<std::uint32_t>& against, Scratch& scratch, std::vector<Pair>& found)
{
	const Box box = boxOf(grid, cell.cell, scratch.mine.faces);
	scratch.near.clear();
	for (const std::uint32_t b : against)
		boxes[b].addMeeting(box, b, scratch.other, scratch.near);
	scratch.points.clear();
	for (const SetCell& that : scratch.near)
	{
		if (that == cell)
			continue;
		if (scratch.points.empty())
		{
			scratch.mine.fetch(grid, cell.cell);
			scratch.points.push_back(scratch.mine.center);
			for (const Vec3& corner : scratch.mine.places)
				if (const Vec3 p = 0.5 * (scratch.mine.center + corner);
				    std::ranges::find(scratch.points, p) == scratch.points.end())
					scratch.points.push_back(p);
			std::erase_if(scratch.points, [&](const Vec3& p) { return !liesInside(scratch.mine, p); });
			if (scratch.points.empty())
				return;
		}
		std::visit(
		    [&](const auto& other_grid)
		    {
			    const Box other_box = boxOf(other_grid, that.cell, scratch.other.faces);
			    if (std::ranges::none_of(scratch.points, [&](const Vec3& p) { return holds(other_box, p); }))
				    return;
			    scratch.other.fetch(other_grid, that.cell);
			    if (std::ranges::any_of(scratch.points, [&](const Vec3& p) { return liesInside(scratch.other, p); }))
				    found.push_back(std::minmax(cell, that));
		    },
		    set.blocks[that.block].grid);
	}
}

// Looks at cells of block a that lie within the bounds of b, and counts those that hold a point in common with one of
// b.
void lookBetween(const BlockSet& set, std::uint32_t a, std::uint32_t b, std::span<const CellBoxes> boxes,
                 BlockOverlap& overlap)
{
	Scratch scratch;
	std::vector<SetCell> within;
	boxes[a].addMeeting(set.blocks[b].bounds, a, scratch.other, within);
	const std::vector<std::uint32_t> against{b};
	std::vector<Pair> found;
	const std::size_t samples = std::min(kPairSamples, within.size());
	for (std::size_t s = 0; s < samples; ++s)
	{
		found.clear();
		std::visit([&](const auto& grid)
		           { lookAt(set, grid, within[s * within.size() / samples], boxes, against, scratch, found); },
		           set.blocks[a].grid);
		overlap.cells += !found.empty();
	}
	overlap.samples += samples;
}

} // namespace

std::vector<BlockOverlap> findBlockOverlaps(const BlockSet& set)
{
	std::vector<BlockOverlap> pairs;
	std::vector<bool> wanted(set.blocks.size(), false);
	for (std::uint32_t a = 0; a < set.blocks.size(); ++a)
		for (std::uint32_t b = a + 1; b < set.blocks.size(); ++b)
			if (meet(set.blocks[a].bounds, set.blocks[b].bounds))
			{
				pairs.push_back({a, b, 0, 0});
				wanted[a] = wanted[b] = true;
			}
	std::vector<CellBoxes> boxes;
	boxes.reserve(set.blocks.size());
	for (std::size_t b = 0; b < set.blocks.size(); ++b)
		boxes.emplace_back(set.blocks[b], wanted[b]);
	tbb::parallel_for(std::size_t(0), pairs.size(),
	                  [&](std::size_t p)
	                  {
		                  lookBetween(set, pairs[p].a, pairs[p].b, boxes, pairs[p]);
		                  lookBetween(set, pairs[p].b, pairs[p].a, boxes, pairs[p]);
	                  });
	std::erase_if(pairs, [](const BlockOverlap& pair) { return pair.cells == 0; });
	return pairs;
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
				against.push_back(o);
		if (against.empty())
			continue;
		std::visit(
		    [&](const auto& grid)
		    {
			    const std::size_t samples = std::min(kSamples, grid.cellCount());
			    quality.overlap_samples += samples;
			    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples, 64),
			                      [&](const auto& range)
			                      {
				                      Scratch scratch;
				                      for (std::size_t s = range.begin(); s < range.end(); ++s)
					                      lookAt(set, grid,
					                             SetCell{b, static_cast<CellId>(s * grid.cellCount() / samples)}, boxes,
					                             against, scratch, found.local());
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
