#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/grid.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::grid
{

// The faces of a block that have no neighbor. Faces that lie together form a patch, patches form a group, and each has
// a box. So the time to find the faces that a surface cuts depends on their number. A patch has up to 16 faces (4 x 4
// on the side of a lattice), a group has up to 64 patches (32 x 32 faces).
struct BoundaryIndex
{
	struct Face
	{
		CellId cell;
		std::uint32_t face;
	};
	struct Range
	{
		Box box;             // around all points of its faces
		std::uint32_t begin; // first face of a patch, or first patch of a group
		std::uint32_t end;
	};
	std::vector<Face> faces;
	// The points of each face, in the order of its cell. A triangle has its last point twice. Filled only for grids
	// that keep coordinates, and only if no face has more than four points.
	std::vector<std::array<PointId, 4>> corners;
	std::vector<Range> patches;
	std::vector<Range> groups;

	// Calls visit(faces of a patch) for every patch of the groups [begin, end) whose box passes meets(box). Returns the
	// number of boxes that were asked.
	template <class Meets, class Visit>
	std::size_t visitWhere(std::size_t begin, std::size_t end, Meets&& meets, Visit&& visit) const
	{
		std::size_t tests = end - begin;
		for (std::size_t g = begin; g < end; ++g)
		{
			const Range& group = groups[g];
			if (!meets(group.box))
				continue;
			tests += group.end - group.begin;
			for (std::uint32_t p = group.begin; p < group.end; ++p)
				if (meets(patches[p].box))
					visit(std::span(faces).subspan(patches[p].begin, patches[p].end - patches[p].begin));
		}
		return tests;
	}
	// The same for every face of every patch in all groups.
	template <class Meets, class Visit>
	std::size_t visitWhere(Meets&& meets, Visit&& visit) const
	{
		return visitWhere(0, groups.size(), meets,
		                  [&](std::span<const Face> patch)
		                  {
			                  for (const Face& face : patch)
				                  visit(face);
		                  });
	}
};

// Builds the index of one of the four grids of block.h. In a lattice, every side of a cell on the border is a boundary
// face, even one without area. In an unstructured grid, every face without a cell across is one, except faces with
// fewer than three different points.
template <Grid G>
BoundaryIndex buildBoundaryIndex(const G& grid);

} // namespace vp::grid
