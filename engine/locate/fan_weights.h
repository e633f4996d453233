#pragma once

#include "grid/cell_places.h"
#include "grid/grid.h"
#include "locate/interpolate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace vp::locate
{

// Returns x with x0 a0 + x1 a1 + x2 a2 = b, by Cramer's rule. It is not finite if the three lie in a plane.
inline Vec3 solve(const std::array<Vec3, 3>& a, const Vec3& b)
{
	const Vec3 across = glm::cross(a[1], a[2]);
	const Vec3 turned = glm::cross(a[0], b);
	return Vec3(glm::dot(b, across), glm::dot(a[2], turned), -glm::dot(a[1], turned)) / glm::dot(a[0], across);
}

// Returns true if x is a solution. If the three lie in a plane up to rounding, x may be finite and mean nothing.
inline bool solves(const std::array<Vec3, 3>& a, const Vec3& x, const Vec3& b)
{
	constexpr double kRounding = 1e-11;
	const double size = std::max({glm::length(a[0]), glm::length(a[1]), glm::length(a[2]), glm::length(b)});
	return glm::length(x.x * a[0] + x.y * a[1] + x.z * a[2] - b) <= kRounding * size; // false for NaN
}

// A tetrahedron of a cell: the mean of the cell's points, that of a face's, and an edge of the face.
struct FanPart
{
	int face = -1;
	std::size_t edge = 0;           // index of the edge: from this point of the face to the next
	std::array<double, 4> weight{}; // weights of the cell, the face, and the edge's begin and end
	double least = -std::numeric_limits<double>::infinity(); // least of the weights

	// Returns the depth in the cell, not in the part: a place between two parts may be far inside the cell.
	double depth() const
	{
		const double rim = std::min({weight[1], weight[2], weight[3]});
		return rim >= -1e-9 ? weight[0] : least;
	}
};

// Means and places are relative to a point of the cell. grid: a grid, or what else knows point(PointId) of the faces.
template <class Points>
FanPart deepestPart(const Points& grid, const grid::CellFaces& faces, const Vec3& origin, const Vec3& center,
                    const Vec3& place)
{
	FanPart deepest;
	for (int f = 0; f < faces.size(); ++f)
	{
		const std::span<const PointId> face = faces[f];
		Vec3 middle(0.0);
		for (const PointId p : face)
			middle += (grid.point(p) - origin) / static_cast<double>(face.size());
		for (std::size_t e = 0; e < face.size(); ++e)
		{
			const Vec3 begin = grid.point(face[e]) - origin;
			const Vec3 end = grid.point(face[(e + 1) % face.size()]) - origin;
			const std::array<Vec3, 3> sides{middle - center, begin - center, end - center};
			const Vec3 w = solve(sides, place - center);
			const double least = std::min({1.0 - w.x - w.y - w.z, w.x, w.y, w.z});
			if (least > deepest.least && solves(sides, w, place - center))
				deepest = {f, e, {1.0 - w.x - w.y - w.z, w.x, w.y, w.z}, least};
		}
	}
	return deepest;
}

// The depth of a place that is so deep in a tetrahedron of its cell. Those of a concave cell, and of one with holes,
// reach out of it.
template <grid::Grid G>
double trueDepth(const G& grid, CellId cell, const Vec3& place, const Vec3& center, double depth)
{
	constexpr double kOutside = 1e-6;
	if (depth < -1e-9)
		return depth;
	grid::CellPlaces places;
	places.fetch(grid, cell);
	if (grid::isStarAbout(places, center))
		return depth;
	const std::optional<bool> enclosed = grid::isEnclosed(places, place);
	return !enclosed ? 0.0 : *enclosed ? std::max(depth, 0.0) : -std::max(depth, kOutside);
}

// Does the work of weighCellByTetrahedra() (interpolate.h). If two parts contain a place, as in concave cells, the
// deeper one is used.
template <grid::Grid G>
void weighFan(const G& grid, CellId cell, const Vec3& place, CellWeights& found)
{
	grid::CellFaces faces;
	grid.cellFaces(cell, faces);
	found.points = faces.points;
	std::ranges::sort(found.points);
	found.points.erase(std::unique(found.points.begin(), found.points.end()), found.points.end());
	const Vec3 origin = grid.point(found.points.front());
	const double each = 1.0 / static_cast<double>(found.points.size());
	Vec3 center(0.0);
	for (const PointId p : found.points)
		center += each * (grid.point(p) - origin);
	const FanPart part = deepestPart(grid, faces, origin, center, place - origin);
	if (part.face < 0)
	{
		found = {{}, {}, part.least};
		return;
	}
	found.depth = trueDepth(grid, cell, place, origin + center, part.depth());
	found.weights.assign(found.points.size(), part.weight[0] * each);
	const auto add = [&](PointId p, double weight)
	{ found.weights[std::ranges::lower_bound(found.points, p) - found.points.begin()] += weight; };
	const std::span<const PointId> face = faces[part.face];
	for (const PointId p : face)
		add(p, part.weight[1] / static_cast<double>(face.size()));
	add(face[part.edge], part.weight[2]);
	add(face[(part.edge + 1) % face.size()], part.weight[3]);
}

} // namespace vp::locate
