#pragma once

#include "grid/cell_list.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::read
{

/// Returns the number of sides of VTK's prisms over pentagons and hexagons, 0 for other types.
constexpr int prismSides(std::uint8_t type)
{
	return type == 15 ? 5 : type == 16 ? 6 : 0;
}

/// Returns the faces of a prism over a polygon, as a stream: their number, then per face its size and points. The
/// points of the one end come first, then those of the other.
template <class Id>
std::vector<Id> prismFaces(std::span<const Id> points)
{
	const std::size_t sides = points.size() / 2;
	const Id count = static_cast<Id>(sides);
	std::vector<Id> stream = {count + 2, count};
	stream.insert(stream.end(), points.rbegin() + static_cast<std::ptrdiff_t>(sides), points.rend());
	stream.push_back(count);
	stream.insert(stream.end(), points.begin() + static_cast<std::ptrdiff_t>(sides), points.end());
	for (std::size_t i = 0; i < sides; ++i)
	{
		const std::size_t next = (i + 1) % sides;
		stream.insert(stream.end(), {4, points[i], points[next], points[sides + next], points[sides + i]});
	}
	return stream;
}

/// Makes polyhedra of the prisms over pentagons and hexagons. The cells have offsets. Throws Unusable if a prism lists
/// too few points, or the offsets do not fit the points.
void rewritePrisms(grid::CellList& cells);

} // namespace vp::read
