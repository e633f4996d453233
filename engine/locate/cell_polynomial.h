#pragma once

#include "locate/fan_weights.h"
#include "locate/shape_place.h"

#include <array>
#include <cmath>
#include <span>

namespace vp::locate
{

// The interpolation of corner values (places, vectors) by VTK's shape functions, sorted by powers of the cell's own
// coordinates (shape_place.h). The shapes differ in the powers that they have. Use it for many places in one cell, and
// interpolate.h for one place.
//
//   value(u, v, w) = constant + x u + y v + z w + xy u v + xz u w + yz v w + xyz u v w
//
// For a pyramid u v / (1 - w) replaces u v.
struct CellPolynomial
{
	Vec3 constant{0.0}, x{0.0}, y{0.0}, z{0.0}, xy{0.0}, xz{0.0}, yz{0.0}, xyz{0.0};

	// Without a call, which would cost a trace more than what is worked out.
	[[gnu::always_inline]] Vec3 at(grid::CellShape shape, const Vec3& u) const
	{
		if (shape == grid::CellShape::pyramid)
			return constant + u.x * x + u.y * y + u.z * z + crossTerm(u) * xy;
		return constant + u.y * y + u.z * (z + u.y * yz) + u.x * (x + u.z * xz + u.y * (xy + u.z * xyz));
	}

	std::array<Vec3, 3> slopesAt(grid::CellShape shape, const Vec3& u) const
	{
		if (shape == grid::CellShape::pyramid)
		{
			const double below = 1.0 - u.z;
			const double r = below == 0.0 ? 0.5 : u.x / below;
			const double s = below == 0.0 ? 0.5 : u.y / below;
			return {x + s * xy, y + r * xy, z + r * s * xy};
		}
		return {x + u.y * xy + u.z * (xz + u.y * xyz), y + u.x * xy + u.z * (yz + u.x * xyz),
		        z + u.x * xz + u.y * (yz + u.x * xyz)};
	}

	// Returns true if it is linear up to rounding, so that the slopes are the same everywhere.
	bool isAffine() const
	{
		constexpr double kRounding = 1e-12;
		const double size = std::max({glm::dot(x, x), glm::dot(y, y), glm::dot(z, z)});
		const double bend = std::max({glm::dot(xy, xy), glm::dot(xz, xz), glm::dot(yz, yz), glm::dot(xyz, xyz)});
		return bend <= kRounding * kRounding * size;
	}

private:
	static double crossTerm(const Vec3& u) { return u.z == 1.0 ? 0.0 : u.x * u.y / (1.0 - u.z); }
};

// p: values at the corners of a table shape, in VTK's order.
inline CellPolynomial cellPolynomial(grid::CellShape shape, std::span<const Vec3> p)
{
	CellPolynomial of;
	of.constant = p[0];
	of.x = p[1] - p[0];
	switch (shape)
	{
	case grid::CellShape::tetrahedron:
		of.y = p[2] - p[0];
		of.z = p[3] - p[0];
		break;
	case grid::CellShape::pyramid:
		of.y = p[3] - p[0];
		of.z = p[4] - p[0];
		of.xy = (p[2] - p[3]) - of.x;
		break;
	case grid::CellShape::wedge:
		of.y = p[2] - p[0];
		of.z = p[3] - p[0];
		of.xz = (p[4] - p[3]) - of.x;
		of.yz = (p[5] - p[3]) - of.y;
		break;
	default:
		of.y = p[3] - p[0];
		of.z = p[4] - p[0];
		of.xy = (p[2] - p[3]) - of.x;
		of.xz = (p[5] - p[4]) - of.x;
		of.yz = (p[7] - p[4]) - of.y;
		of.xyz = ((p[6] - p[7]) - (p[5] - p[4])) - of.xy;
	}
	return of;
}

// Returns m with m[a] . slopes[b] = 1 for a = b, else 0. It turns steps in space into steps in the cell's own
// coordinates. It is not finite if the slopes lie in a plane.
inline std::array<Vec3, 3> inverseOf(const std::array<Vec3, 3>& slopes)
{
	const Vec3 across = glm::cross(slopes[1], slopes[2]);
	const double each = 1.0 / glm::dot(slopes[0], across);
	return {each * across, each * glm::cross(slopes[2], slopes[0]), each * glm::cross(slopes[0], slopes[1])};
}

[[gnu::always_inline]] inline Vec3 applied(const std::array<Vec3, 3>& inverse, const Vec3& step)
{
	return {glm::dot(inverse[0], step), glm::dot(inverse[1], step), glm::dot(inverse[2], step)};
}

// Improves the guess u by Newton's method. `place` has the units and the origin of the polynomial. Returns false if the
// method does not converge, as in cells without volume and far outside. Then u means nothing.
inline bool findPlace(const CellPolynomial& places, grid::CellShape shape, const Vec3& place, Vec3& u)
{
	constexpr int kMaxSteps = 16;
	// Steps square the error, so after such a one it is 1e-8 of the cell at most, and 1e-10 in cells that are nearly
	// parallelepipeds.
	constexpr double kSmall = 1e-4;
	constexpr double kFar = 1e2; // cells away
	for (int step = 0; step < kMaxSteps; ++step)
	{
		const Vec3 move = solve(places.slopesAt(shape, u), place - places.at(shape, u));
		u += move;
		const double length = std::abs(move.x) + std::abs(move.y) + std::abs(move.z);
		if (length < kSmall)
			return true;
		if (!(length < kFar)) // NaN too
			return false;
	}
	return false;
}

} // namespace vp::locate
