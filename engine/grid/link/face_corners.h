#pragma once

#include "grid/boundary.h"
#include "grid/grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vp::grid
{

// The corners of a face, each place once: neighbors around the face that coincide are one.
template <Grid G>
void faceCorners(const G& grid, const BoundaryIndex::Face& face, CellFaces& faces, std::vector<Vec3>& found)
{
	grid.cellFaces(face.cell, faces);
	found.clear();
	for (const PointId p : faces[static_cast<int>(face.face)])
		if (const Vec3 x = grid.point(p); found.empty() || x != found.back())
			found.push_back(x);
	while (found.size() > 1 && found.back() == found.front())
		found.pop_back();
}

// Points of these lie apart by construction.
inline bool meetsItself(const AnyGrid& grid)
{
	return !std::holds_alternative<UniformGrid>(grid) && !std::holds_alternative<RectilinearGrid>(grid);
}

// A bucket holds what lies in one cube of a lattice of cubes that are 2^level wide.
inline std::uint64_t bucketOf(int level, const Vec3& place)
{
	std::uint64_t hash = static_cast<std::uint64_t>(level) * 0x9E3779B97F4A7C15u;
	const double cubes = std::ldexp(1.0, std::min(-level, 1000)); // in a unit of length
	for (int axis = 0; axis < 3; ++axis)
	{
		const double at = std::clamp(std::floor(place[axis] * cubes), -9e18, 9e18);
		hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(at))) * 0xBF58476D1CE4E5B9u;
		hash ^= hash >> 29;
	}
	return hash;
}

} // namespace vp::grid
