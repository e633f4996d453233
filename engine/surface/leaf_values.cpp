#include "surface/leaf_values.h"

#include "base/parallel_for.h"
#include "grid/shown_value.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace vp::surface
{

namespace
{

constexpr float kInfinity = std::numeric_limits<float>::infinity();

} // namespace

LeafValues::LeafValues(const grid::Block& block, const grid::Field& field, int component)
{
	const grid::BlockTree& tree = grid::treeOf(block);
	leaves_.resize(tree.leaves().size());
	std::atomic<bool> all_finite = true;
	const auto scan = [&](const auto& grid, std::size_t leaf)
	{
		double lo = std::numeric_limits<double>::infinity();
		double hi = -lo;
		grid::CellFaces faces;
		const auto see = [&](PointId p)
		{
			const double value = grid::shownValue(field, grid.sourcePoint(p), component);
			if (!std::isfinite(value))
			{
				all_finite = false;
				return;
			}
			lo = std::min(lo, value);
			hi = std::max(hi, value);
		};
		tree.forEachCell(tree.leaves()[leaf],
		                 [&](CellId cell)
		                 {
			                 if (grid.shape(cell) != grid::CellShape::polyhedron)
			                 {
				                 for (const PointId p : grid.cellPoints(cell))
					                 see(p);
				                 return;
			                 }
			                 grid.cellFaces(cell, faces);
			                 for (const PointId p : faces.points)
				                 see(p);
		                 });
		leaves_[leaf] = {std::nextafter(static_cast<float>(lo), -kInfinity),
		                 std::nextafter(static_cast<float>(hi), kInfinity)};
	};
	std::visit([&](const auto& grid)
	           { tracedFor(std::size_t(0), leaves_.size(), [&](std::size_t leaf) { scan(grid, leaf); }); },
	           block.grid);
	all_finite_ = all_finite;
	for (const grid::BlockTree::Node& group : tree.groups())
	{
		Span all{kInfinity, -kInfinity};
		for (std::uint32_t leaf = group.begin; leaf < group.end; ++leaf)
			all = {std::min(all.first, leaves_[leaf].first), std::max(all.second, leaves_[leaf].second)};
		groups_.push_back(all);
	}
}

} // namespace vp::surface
