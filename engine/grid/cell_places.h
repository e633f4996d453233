#pragma once

#include "grid/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace vp::grid
{

// The faces of a cell with the places of their points.
struct CellPlaces
{
	CellFaces faces;
	std::vector<Vec3> places;
	Vec3 center{0.0};

	std::span<const Vec3> face(int f) const { return {places.data() + faces.starts[f], faces[f].size()}; }

	template <Grid G>
	void fetch(const G& grid, CellId cell)
	{
		grid.cellFaces(cell, faces);
		places.clear();
		for (const PointId p : faces.points)
			places.push_back(grid.point(p));
		center = cellCenter(grid, cell);
	}
};

// Calls visit(a, b, c) for each triangle of the fans of the cell's faces about their means. Cells that share a face
// share its fan.
template <class Visit>
void forFanTriangles(const CellPlaces& cell, Visit&& visit)
{
	for (int f = 0; f < cell.faces.size(); ++f)
	{
		const std::span<const Vec3> face = cell.face(f);
		Vec3 middle(0.0);
		for (const Vec3& p : face)
			middle += p / static_cast<double>(face.size());
		for (std::size_t i = 0; i < face.size(); ++i)
			visit(middle, face[i], face[(i + 1) % face.size()]);
	}
}

// Returns whether the point lies inside the closed surface of the faces' fans, whatever the form of the cell: concave,
// or with holes. Counted are the tetrahedra between an apex and the fans' triangles that hold the point: they are odd
// in number if it is inside, wherever the apex is. Returns nothing for a point on the surface, up to rounding.
inline std::optional<bool> isEnclosed(const CellPlaces& cell, const Vec3& point)
{
	constexpr double kRim = 1e-9;
	// Between tetrahedra of one apex lie walls, on which a point may be counted twice. Those of another apex lie
	// elsewhere.
	constexpr std::array<Vec3, 4> kApexes{Vec3(0.0), Vec3(0.137, 0.071, -0.113), Vec3(-0.083, 0.149, 0.059),
	                                      Vec3(0.061, -0.127, 0.173)};
	Box box;
	for (const Vec3& p : cell.places)
		box.include(p);
	for (const Vec3& step : kApexes)
	{
		const Vec3 apex = cell.center + step * box.size();
		const Vec3 p = point - apex;
		bool inside = false;
		bool on_wall = false;
		forFanTriangles(cell,
		                [&](const Vec3& place_a, const Vec3& place_b, const Vec3& place_c)
		                {
			                const Vec3 a = place_a - apex;
			                const Vec3 b = place_b - apex;
			                const Vec3 c = place_c - apex;
			                const double volume = glm::dot(a, glm::cross(b, c));
			                if (volume == 0.0)
				                return;
			                const double wa = glm::dot(p, glm::cross(b, c)) / volume;
			                const double wb = glm::dot(a, glm::cross(p, c)) / volume;
			                const double wc = glm::dot(a, glm::cross(b, p)) / volume;
			                const double least = std::min({wa, wb, wc, 1.0 - wa - wb - wc});
			                on_wall = on_wall || std::abs(least) <= kRim;
			                inside = inside != (least > 0.0);
		                });
		if (!on_wall)
			return inside;
	}
	return std::nullopt;
}

// Returns true if the center sees all of the cell's surface: Then the solid angles of the faces' fans add up to the
// whole sphere, and the tetrahedra between the center and the fans do not overlap.
inline bool isStarAbout(const CellPlaces& cell, const Vec3& center)
{
	constexpr double kSphere = 4.0 * std::numbers::pi;
	constexpr double kRounding = 1e-6;
	double angles = 0.0;
	// Van Oosterom and Strackee, "The Solid Angle of a Plane Triangle" (1983).
	forFanTriangles(cell,
	                [&](const Vec3& place_a, const Vec3& place_b, const Vec3& place_c)
	                {
		                const Vec3 a = place_a - center;
		                const Vec3 b = place_b - center;
		                const Vec3 c = place_c - center;
		                const double la = glm::length(a);
		                const double lb = glm::length(b);
		                const double lc = glm::length(c);
		                const double below =
		                    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
		                angles += 2.0 * std::atan2(std::abs(glm::dot(a, glm::cross(b, c))), below);
	                });
	return std::abs(angles - kSphere) <= kRounding * kSphere;
}

// Returns true if the point lies inside the cell, deeper than mere contact. The cell is taken as the tetrahedra between
// its center and the fans of its faces.
inline bool liesInside(const CellPlaces& cell, const Vec3& point)
{
	// The depth of contact, as a part of the way from a face to the center of the cell.
	constexpr double kDepth = 1e-2;
	constexpr double kRim = 1e-9; // between the tetrahedra
	int holding = 0;
	bool deep = false;
	forFanTriangles(cell,
	                [&](const Vec3& place_a, const Vec3& place_b, const Vec3& place_c)
	                {
		                const Vec3 a = place_a - cell.center;
		                const Vec3 b = place_b - cell.center;
		                const Vec3 c = place_c - cell.center;
		                const double volume = glm::dot(a, glm::cross(b, c));
		                if (volume == 0.0)
			                return;
		                const Vec3 p = point - cell.center;
		                const double wa = glm::dot(p, glm::cross(b, c)) / volume;
		                const double wb = glm::dot(a, glm::cross(p, c)) / volume;
		                const double wc = glm::dot(a, glm::cross(b, p)) / volume;
		                if (wa < -kRim || wb < -kRim || wc < -kRim || wa + wb + wc > 1.0 + kRim)
			                return;
		                ++holding;
		                deep = deep || wa + wb + wc <= 1.0 - kDepth;
	                });
	if (!deep || holding == 1)
		return deep;
	if (isStarAbout(cell, cell.center))
		return true;
	// Some tetrahedra reach out of the cell, and the depth in one tells nothing. So the places around the point must be
	// inside, too.
	Box box;
	for (const Vec3& p : cell.places)
		box.include(p);
	const Vec3 size = box.size();
	const double around = 0.5 * kDepth * std::min({size.x, size.y, size.z});
	for (int axis = 0; axis < 3; ++axis)
		for (const double side : {-around, around})
		{
			Vec3 beside = point;
			beside[axis] += side;
			if (!isEnclosed(cell, beside).value_or(false))
				return false;
		}
	return isEnclosed(cell, point).value_or(false);
}

} // namespace vp::grid
