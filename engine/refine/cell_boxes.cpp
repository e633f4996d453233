#include "refine/cell_boxes.h"

#include "base/parallel_for.h"
#include "grid/link/morton.h"
#include "refine/tetrahedron.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::refine
{

namespace
{

constexpr std::size_t kCells = 16;

/// Returns the bounds of a cell's control points, which contain the whole cell. nodes: gets the bounds of its nodes.
Box boxOf(const grid::CurvedCells& curved, std::size_t cell, const CellKind& kind, Box& nodes)
{
	std::vector<double> at(3 * kind.nodes());
	for (std::size_t n = 0; n < kind.nodes(); ++n)
	{
		const Vec3 node = curved.points[curved.node(cell, n)];
		nodes.include(node);
		std::copy_n(&node.x, 3, &at[3 * n]);
	}
	std::vector<Vec3> lattice(kind.lattice());
	kind.toLattice(at.data(), 3, &lattice.data()->x);
	std::vector<Vec3> control;
	kind.controlPoints(lattice, control);
	Box box;
	for (const Vec3& point : control)
		box.include(point);
	return box;
}

Box boxOf(const grid::CurvedCells& curved, const CellKinds& kinds, std::size_t cell, Box& nodes)
{
	Box box;
	const std::uint8_t type = curved.cells.types[cell];
	if (grid::isSliceable(type))
	{
		curved.cells.forEachPoint(cell,
		                          [&](std::int64_t p) { box.include(curved.points[static_cast<std::size_t>(p)]); });
		nodes.include(box);
		return box;
	}
	if (!curved.isCurved(cell))
		return box;
	if (!curved.isQuadratic(cell))
		return boxOf(curved, cell, kinds.of(cell), nodes);
	std::array<Vec3, grid::kQuadraticTetraNodes> at;
	const std::size_t first = curved.start(cell);
	for (std::size_t n = 0; n < at.size(); ++n)
		at[n] = curved.points[static_cast<std::size_t>(curved.cells.connectivity[first + n])];
	for (const Vec3& node : at)
		box.include(node);
	nodes.include(box);
	for (std::size_t e = 0; e < 6; ++e)
		box.include(2.0 * at[4 + e] - 0.5 * (at[kEdges[e][0]] + at[kEdges[e][1]]));
	return box;
}

Vec3 firstPoint(const grid::CurvedCells& curved, std::size_t cell)
{
	return curved.points[static_cast<std::size_t>(curved.cells.connectivity[curved.start(cell)])];
}

} // namespace

CellBoxes::CellBoxes(const grid::CurvedCells& curved, const CellKinds& kinds)
{
	const std::size_t count = curved.cells.size();
	Box corners;
	for (std::size_t c = 0; c < count; ++c)
		if (curved.isCut(c))
			corners.include(firstPoint(curved, c));
	const grid::MortonCurve curve(corners);
	grid::KeyedIds keys(count);
	tracedFor(std::size_t(0), count,
	          [&](std::size_t c)
	          {
		          keys[c] = {curved.isCut(c) ? curve(firstPoint(curved, c)) : grid::MortonCurve::kLast,
		                     static_cast<std::uint32_t>(c)};
	          });
	grid::sortByKey(keys);
	cells_.resize(count);
	boxes_.resize((count + kCells - 1) / kCells);
	std::vector<Box> nodes(boxes_.size());
	tracedFor(std::size_t(0), boxes_.size(),
	          [&](std::size_t b)
	          {
		          for (std::size_t i = b * kCells; i < std::min((b + 1) * kCells, count); ++i)
		          {
			          cells_[i] = keys[i].id;
			          boxes_[b].include(boxOf(curved, kinds, cells_[i], nodes[b]));
		          }
	          });
	Box bounds;
	for (const Box& box : nodes)
		bounds.include(box);
	if (!bounds.empty())
		for (int axis = 0; axis < 3; ++axis)
			reach_ = std::max({reach_, std::abs(bounds.lo[axis]), std::abs(bounds.hi[axis])});
}

std::vector<std::uint32_t> CellBoxes::cellsNear(const Sheets& sheets) const
{
	std::vector<std::uint32_t> near;
	for (std::size_t b = 0; b < boxes_.size(); ++b)
		if (sheets.meet(boxes_[b]))
			near.insert(near.end(), cells_.begin() + static_cast<std::ptrdiff_t>(b * kCells),
			            cells_.begin() + static_cast<std::ptrdiff_t>(std::min((b + 1) * kCells, cells_.size())));
	return near;
}

} // namespace vp::refine
