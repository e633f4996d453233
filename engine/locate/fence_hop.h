#pragma once

#include "base/ids.h"
#include "grid/grid.h"
#include "locate/face_plane.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace vp::locate
{

// The end of a hop, and the cell where it ended.
struct Hop
{
	enum class End
	{
		found,     // every t > 1, so the target lies in `cell`
		left_grid, // the line left through a boundary face of `cell`
		looped     // went in a circle: the cells are too warped for faces of infinite extent
	};
	End end;
	CellId cell;
	int face = -1;        // left_grid: the face through which it left
	std::size_t hops = 0; // cells entered after the first
};

// Speray and Kennon's fence hopping: from a point in `start` along the line to `target`, with t = 0 at the start point
// and t = 1 at the target. Each face counts as the infinite plane that fits it. The line leaves through the face
// with the least positive t. If every t > 1, the target is in the cell. In each further cell the start point is moved
// from the point of entry toward the middle of the entry face and a little into the cell, away from edges and vertices.
//
// Ends as `looped` after max_hops, or earlier if a cell is met again (Brent's cycle detection).
template <grid::Grid G>
Hop fenceHop(const G& grid, CellId start, const Vec3& target, std::size_t max_hops)
{
	grid::CellFaces faces;
	Vec3 from = cellCenter(grid, start);
	Hop hop{Hop::End::looped, start};
	CellId landmark = kNoCell; // Brent: moved to the present cell at every power of two
	std::size_t next_landmark = 1;
	for (;; ++hop.hops)
	{
		if (hop.hops > max_hops || hop.cell == landmark)
			return hop;
		if (hop.hops == next_landmark)
		{
			landmark = hop.cell;
			next_landmark *= 2;
		}

		grid.cellFaces(hop.cell, faces);
		const Vec3 center = cellCenter(grid, hop.cell);
		const Vec3 along = target - from;
		double least = std::numeric_limits<double>::infinity();
		int exit = -1;
		for (int f = 0; f < faces.size(); ++f)
		{
			const FacePlane plane = facePlane(grid, faces[f]);
			if (plane.normal == Vec3(0.0))
				continue; // a collapsed face has no area to leave through
			// Positive toward the outside, for either orientation of the cell.
			const double side = glm::dot(plane.normal, plane.center - center) < 0.0 ? -1.0 : 1.0;
			const double approach = side * glm::dot(plane.normal, along);
			if (approach <= 0.0)
				continue; // the line runs away from this face
			const double t = std::max(0.0, side * glm::dot(plane.normal, plane.center - from) / approach);
			if (t < least)
			{
				least = t;
				exit = f;
			}
		}
		if (exit < 0 || least >= 1.0)
		{
			hop.end = Hop::End::found;
			return hop;
		}

		CellId next = kNoCell;
		const Vec3 crossing = from + least * along;
		double nearest = std::numeric_limits<double>::infinity();
		// Several cells may lie behind a face: the one that is entered is the one whose center is nearest to the
		// crossing.
		grid.forEachNeighbor(hop.cell, exit,
		                     [&](CellId candidate)
		                     {
			                     const double distance = glm::length(cellCenter(grid, candidate) - crossing);
			                     if (distance < nearest)
			                     {
				                     nearest = distance;
				                     next = candidate;
			                     }
		                     });
		if (next == kNoCell)
		{
			hop.end = Hop::End::left_grid;
			hop.face = exit;
			return hop;
		}
		const FacePlane entry = facePlane(grid, faces[exit]);
		hop.cell = next;
		from = 0.5 * (crossing + entry.center);
		from += 0.1 * (cellCenter(grid, next) - from);
	}
}

} // namespace vp::locate
