#include "vectors/concave_way.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vp::vectors
{

namespace
{

template <class Visit>
void forFaceTriangles(const grid::CellPlaces& cell, Visit&& visit)
{
	for (int f = 0; f < cell.faces.size(); ++f)
	{
		const std::span<const Vec3> face = cell.face(f);
		Vec3 middle(0.0);
		for (const Vec3& p : face)
			middle += p / static_cast<double>(face.size());
		for (std::size_t i = 0; i < face.size(); ++i)
			visit(f, middle, face[i], face[(i + 1) % face.size()]);
	}
}

// Returns where the way passes a triangle of the surface (Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
// Intersection", 1997). Rounding may count a place at a side twice, which does no harm.
std::optional<double> passes(const Vec3& from, const Vec3& way, const Vec3& a, const Vec3& b, const Vec3& c)
{
	constexpr double kRounding = 1e-9;
	const Vec3 ab = b - a;
	const Vec3 ac = c - a;
	const Vec3 across = glm::cross(way, ac);
	const double volume = glm::dot(ab, across);
	if (volume == 0.0)
		return std::nullopt;
	const Vec3 arm = from - a;
	const double u = glm::dot(arm, across) / volume;
	const Vec3 turned = glm::cross(arm, ab);
	const double v = glm::dot(way, turned) / volume;
	if (!(u >= -kRounding && v >= -kRounding && u + v <= 1.0 + kRounding))
		return std::nullopt;
	return glm::dot(ac, turned) / volume;
}

double squareDistance(const Vec3& p, const Vec3& a, const Vec3& b)
{
	const Vec3 side = b - a;
	const double square = glm::dot(side, side);
	const double at = square > 0.0 ? std::clamp(glm::dot(p - a, side) / square, 0.0, 1.0) : 0.0;
	const Vec3 off = p - (a + at * side);
	return glm::dot(off, off);
}

// To the triangle: where its plane is nearest if that is within it, else to the nearest of its sides.
double squareDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
	const Vec3 normal = glm::cross(b - a, c - a);
	const double square = glm::dot(normal, normal);
	const bool above = square > 0.0 && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0 &&
	                   glm::dot(glm::cross(c - b, p - b), normal) >= 0.0 &&
	                   glm::dot(glm::cross(a - c, p - c), normal) >= 0.0;
	if (!above)
		return std::min({squareDistance(p, a, b), squareDistance(p, b, c), squareDistance(p, c, a)});
	const double height = glm::dot(p - a, normal);
	return height * height / square;
}

int nearestFace(const grid::CellPlaces& cell, const Vec3& place)
{
	int nearest = 0;
	double least = std::numeric_limits<double>::infinity();
	forFaceTriangles(cell,
	                 [&](int f, const Vec3& a, const Vec3& b, const Vec3& c)
	                 {
		                 if (const double distance = squareDistance(place, a, b, c); distance < least)
		                 {
			                 least = distance;
			                 nearest = f;
		                 }
	                 });
	return nearest;
}

} // namespace

std::optional<LeftThrough> whereLeft(const grid::CellPlaces& cell, const Vec3& from, const Vec3& to, double begun,
                                     bool begins_inside)
{
	constexpr double kNothing = 1e-12; // share of the way; nothing fits into less
	const Vec3 way = to - from;
	std::vector<LeftThrough> passed;
	forFaceTriangles(cell,
	                 [&](int f, const Vec3& a, const Vec3& b, const Vec3& c)
	                 {
		                 if (const auto at = passes(from, way, a, b, c); at && *at > begun && *at < 1.0)
			                 passed.push_back({*at, f});
	                 });
	std::ranges::sort(passed, {}, &LeftThrough::part);
	passed.push_back({1.0, -1});
	LeftThrough last{begun, -1};
	bool was_inside = begins_inside;
	for (const LeftThrough& next : passed)
	{
		if (next.part - last.part > kNothing)
		{
			const Vec3 between = from + 0.5 * (last.part + next.part) * way;
			const bool is_inside = grid::isEnclosed(cell, between).value_or(true);
			if (was_inside && !is_inside)
				return LeftThrough{last.part, last.face >= 0 ? last.face : nearestFace(cell, from + last.part * way)};
			was_inside = is_inside;
		}
		last = next;
	}
	return was_inside ? std::nullopt : std::optional(LeftThrough{1.0, nearestFace(cell, to)});
}

} // namespace vp::vectors
