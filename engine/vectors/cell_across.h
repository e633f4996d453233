#pragma once

#include "grid/grid.h"
#include "grid/structured.h"

#include <concepts>
#include <limits>

namespace vp::vectors
{

template <grid::Grid G>
constexpr bool kIsLattice = std::derived_from<G, grid::Lattice>;

// Returns the cell across a face. If there are several, it is the one whose center is nearest to a place, as in fence
// hopping. Returns kNoCell on the boundary.
template <grid::Grid G>
CellId cellAcross(const G& grid, CellId cell, int face, const Vec3& place)
{
	if constexpr (kIsLattice<G>)
		return grid.neighbor(cell, face);
	else
	{
		CellId first = kNoCell;
		bool several = false;
		grid.forEachNeighbor(cell, face,
		                     [&](CellId next)
		                     {
			                     several = first != kNoCell;
			                     first = several ? first : next;
		                     });
		if (!several)
			return first;
		CellId nearest = kNoCell;
		double least = std::numeric_limits<double>::infinity();
		grid.forEachNeighbor(cell, face,
		                     [&](CellId next)
		                     {
			                     const Vec3 off = grid::cellCenter(grid, next) - place;
			                     if (glm::dot(off, off) < least)
			                     {
				                     least = glm::dot(off, off);
				                     nearest = next;
			                     }
		                     });
		return nearest;
	}
}

} // namespace vp::vectors
