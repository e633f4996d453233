#include "find/octant_queue.h"

#include <algorithm>

namespace vp::find
{

bool OctantQueue::mark(CellId cell)
{
	const Vec3 place = placeOf(cell);
	const std::size_t octant = (place.x < center_.x) | (place.y < center_.y) << 1 | (place.z < center_.z) << 2;
	for (const Generation& generation : generations_)
		if (std::find(generation[octant].rbegin(), generation[octant].rend(), cell) != generation[octant].rend())
			return false;
	generations_.front()[octant].push_back(cell);
	return true;
}

void OctantQueue::beginGeneration()
{
	std::rotate(generations_.begin(), generations_.end() - 1, generations_.end());
	for (std::vector<CellId>& octant : generations_.front())
		octant.clear();
}

std::size_t OctantQueue::bytes() const
{
	std::size_t bytes = 0;
	for (const Generation& generation : generations_)
		for (const std::vector<CellId>& octant : generation)
			bytes += octant.capacity() * sizeof(CellId);
	return bytes;
}

// The place of a cell is its first point, for a polyhedron the first point of its faces.
Vec3 OctantQueue::placeOf(CellId cell) const
{
	return std::visit(
	    [&](const auto& grid)
	    {
		    if (grid.shape(cell) != grid::CellShape::polyhedron)
			    return grid.point(grid.cellPoints(cell).id[0]);
		    grid::CellFaces faces;
		    grid.cellFaces(cell, faces);
		    return grid.point(faces.points[0]);
	    },
	    block_->grid);
}

} // namespace vp::find
