#include "refine/refine_block.h"

#include "base/parallel_for.h"
#include "refine/shape_refiner.h"
#include "refine/tetrahedron.h"

#include <algorithm>
#include <atomic>
#include <optional>

namespace vp::refine
{

namespace
{

constexpr std::size_t kCellsAtOnce = 512; // whose parts are listed together, whatever the number of threads

/// Linear cells are parts of themselves.
bool addLinear(const grid::CurvedCells& curved, std::uint32_t cell, std::span<const surface::Plane> planes,
               PartList& parts)
{
	const int count = grid::topology(grid::shapeOf(curved.cells.types[cell])).points;
	const auto node = [&](int n)
	{ return static_cast<std::uint32_t>(curved.cells.connectivity[curved.start(cell) + static_cast<std::size_t>(n)]); };
	const auto isMet = [&](const surface::Plane& plane)
	{
		bool above = false;
		bool below = false;
		for (int n = 0; n < count; ++n)
		{
			const double distance = plane.signedDistance(curved.points[node(n)]);
			above |= distance >= 0.0;
			below |= distance <= 0.0;
		}
		return above && below;
	};
	if (std::ranges::none_of(planes, isMet))
		return false;
	std::array<std::uint32_t, grid::kMaxShapePoints> corners;
	for (int n = 0; n < count; ++n)
		corners[n] = parts.node(node(n), curved.points[node(n)]);
	parts.addPart(curved.cells.types[cell], std::span(corners).first(static_cast<std::size_t>(count)), cell);
	return true;
}

/// Refines a range of cells. Values: how many numbers of a node the tolerance applies to, or more.
template <int Values>
class RangeRefiner
{
public:
	RangeRefiner(const grid::CurvedCells& curved, const CellBoxes& boxes, std::span<const surface::Plane> planes,
	             std::span<const ShownArray> shown)
	    : curved_(curved), planes_(planes), shown_(shown), reach_(boxes.reach())
	{
	}

	void run(std::span<const std::uint32_t> cells, BlockParts& made) const
	{
		TetrahedronRefiner<Values> refiner(planes_, curved_.tolerance, reach_, made.parts);
		for (const std::uint32_t cell : cells)
		{
			if (!curved_.isCut(cell))
				continue;
			if (!curved_.isQuadratic(cell))
			{
				addLinear(curved_, cell, planes_, made.parts);
				continue;
			}
			++made.looked_at;
			std::array<std::uint32_t, grid::kQuadraticTetraNodes> ids;
			Positions at;
			const std::size_t first = curved_.start(cell);
			for (std::size_t n = 0; n < ids.size(); ++n)
			{
				ids[n] = static_cast<std::uint32_t>(curved_.cells.connectivity[first + n]);
				at[n] = curved_.points[ids[n]];
			}
			made.cells += refiner.refine(cell, at, ids, [&](std::uint32_t id, auto& node) { addValues(id, node); });
		}
	}

private:
	void addValues(std::uint32_t id, Node<Values>& node) const
	{
		std::size_t i = 3;
		for (const ShownArray& array : shown_)
			for (int c = 0; c < array.width(); ++c)
				node.at[i++] =
				    array.field->value(id, array.component == grid::kMagnitude ? c : array.component) / array.allowed;
	}

	const grid::CurvedCells& curved_;
	std::span<const surface::Plane> planes_;
	std::span<const ShownArray> shown_;
	double reach_;
};

template <int Values>
BlockParts refineRanges(const RangeRefiner<Values>& refiner, std::span<const std::uint32_t> cells,
                        std::size_t max_parts, const std::stop_token& stop)
{
	const std::size_t ranges = (cells.size() + kCellsAtOnce - 1) / kCellsAtOnce;
	std::vector<std::optional<BlockParts>> made(ranges);
	std::atomic<std::size_t> parts = 0;
	tracedFor(std::size_t(0), ranges,
	          [&](std::size_t r)
	          {
		          if (stop.stop_requested())
			          return;
		          BlockParts& of_range = made[r].emplace(BlockParts{PartList(8 * kCellsAtOnce)});
		          refiner.run(cells.subspan(r * kCellsAtOnce, std::min(kCellsAtOnce, cells.size() - r * kCellsAtOnce)),
		                      of_range);
		          if (parts += of_range.parts.types().size(); parts > max_parts)
			          throw TooManyParts("too many parts");
	          });
	BlockParts all{PartList(parts / 2)};
	for (std::optional<BlockParts>& of_range : made)
	{
		if (!of_range)
			continue;
		all.parts.append(of_range->parts);
		all.looked_at += of_range->looked_at;
		all.cells += of_range->cells;
		of_range.reset();
	}
	return all;
}

/// Cells of any kind, along surfaces of any kind.
BlockParts refineShapes(const grid::CurvedCells& curved, const CellKinds& kinds, const CellBoxes& boxes,
                        const Sheets& sheets, std::span<const ShownArray> shown, std::size_t max_parts,
                        const std::stop_token& stop)
{
	const double slack = 1e-12 * std::max(boxes.reach(), sheets.reach());
	NearCells cells(curved, kinds, sheets, slack, shown);
	cells.add(boxes.cellsNear(sheets));
	ShapeRefiner refiner(curved, cells, sheets, boxes.reach());
	BlockParts made{refiner.refine(max_parts, stop)};
	made.unfinished = refiner.unfinished();
	made.looked_at = cells.curvedLookedAt();
	made.cells = cells.curvedMet();
	return made;
}

} // namespace

BlockParts refineBlock(const grid::CurvedCells& curved, const CellKinds& kinds, const CellBoxes& boxes,
                       const Sheets& sheets, std::span<const ShownArray> shown, std::size_t max_parts,
                       const std::stop_token& stop)
{
	if (!kinds.areQuadraticTetrahedra() || !sheets.others.empty())
		return refineShapes(curved, kinds, boxes, sheets, shown, max_parts, stop);
	const std::span<const surface::Plane> planes = sheets.planes;
	int width = 0;
	for (const ShownArray& array : shown)
		width += array.width();
	const std::vector<std::uint32_t> near = boxes.cellsNear(sheets);
	const auto run = [&]<int Values>()
	{ return refineRanges(RangeRefiner<Values>(curved, boxes, planes, shown), near, max_parts, stop); };
	try
	{
		if (width == 0)
			return run.template operator()<0>();
		if (width == 1)
			return run.template operator()<1>();
		if (width <= 3)
			return run.template operator()<3>();
		return run.template operator()<kMaxShownNumbers>();
	}
	catch (const TooManyParts&)
	{
		// The other way works level by level, and so can end with sides that agree.
		return refineShapes(curved, kinds, boxes, sheets, shown, max_parts, stop);
	}
}

} // namespace vp::refine
