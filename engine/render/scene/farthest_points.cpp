#include "render/scene/farthest_points.h"

#include "grid/farthest_points.h"

namespace vp::render
{

std::vector<Vec3> farthestPoints(const grid::BlockSet& blocks)
{
	Box bounds;
	for (const grid::Block& block : blocks.blocks)
		if (std::holds_alternative<grid::UnstructuredGrid>(block.grid))
			bounds.include(block.bounds);
	if (bounds.empty())
		return {};
	grid::FarthestPoints farthest(bounds.center());
	for (const grid::Block& block : blocks.blocks)
		if (block.whole && !block.whole->farthest.empty())
			farthest.include(block.bounds, block.whole->farthest.size(),
			                 [&](std::size_t p) { return block.whole->farthest[p]; });
		else if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
			farthest.include(block.bounds, grid->usedPointCount(),
			                 [&](std::size_t p) { return grid->point(static_cast<PointId>(p)); });
	return farthest.points();
}

} // namespace vp::render
