#pragma once

#include "base/vec.h"
#include "grid/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vp::grid
{

/// How far the corners of a face may be from those of the face that lies on it, and yet be the same places.
struct FaceTolerance
{
	Vec3 corner{0.0};  // along each axis
	double most = 0.0; // along any axis: no tolerance passes it, so that it cannot close a cell that is flat

	double greatest() const { return std::max({corner.x, corner.y, corner.z}); }
};

/// Returns what two faces allow each other, along each axis.
inline Vec3 toleranceBetween(const FaceTolerance& a, const FaceTolerance& b)
{
	return glm::min(glm::max(a.corner, b.corner), Vec3(std::min(a.most, b.most)));
}

inline bool areOnePlace(const Vec3& p, const Vec3& q, const Vec3& tolerance)
{
	return glm::all(glm::lessThanEqual(glm::abs(p - q), tolerance));
}

/// Returns the distance between two neighboring representable numbers at 1, as the grid stores its coordinates.
template <Grid G>
double storedUlp(const G& grid)
{
	if constexpr (requires { grid.coordinates().isDouble(); })
		if (!grid.coordinates().isDouble())
			return std::numeric_limits<float>::epsilon();
	return std::numeric_limits<double>::epsilon();
}

/// Returns true if all edges that lead away from a face have no length: the cell has no thickness there.
template <Grid G>
bool isFlatAt(const G& grid, const CellFaces& faces, int face)
{
	const auto isOfFace = [&](PointId p) { return std::ranges::find(faces[face], p) != faces[face].end(); };
	for (int f = 0; f < faces.size(); ++f)
	{
		PointId previous = faces[f].back();
		for (const PointId p : faces[f])
		{
			if (isOfFace(p) != isOfFace(previous) && grid.point(p) != grid.point(previous))
				return false;
			previous = p;
		}
	}
	return true;
}

/// Returns the tolerance of a face: 1e-6 of its shortest edge, or 4 ulps of its coordinates along each axis as they are
/// stored, but no more than a quarter of the cell's shortest edge. Edges without length do not count as the shortest.
/// Where the cell has no thickness, only equal places are the same. faces: those of the cell. corners: the places of
/// the face, at least three, each once.
template <Grid G>
FaceTolerance toleranceOf(const G& grid, const CellFaces& faces, int face, std::span<const Vec3> corners)
{
	constexpr double kOfEdge = 1e-6;
	constexpr double kUlps = 4.0;
	constexpr double kMaxOfEdge = 0.25;
	constexpr double kNone = std::numeric_limits<double>::infinity();

	double edge = kNone;
	Vec3 greatest(0.0);
	for (std::size_t i = 0; i < corners.size(); ++i)
	{
		greatest = glm::max(greatest, glm::abs(corners[i]));
		edge = std::min(edge, glm::length(corners[i] - corners[i ? i - 1 : corners.size() - 1]));
	}
	double shortest_of_cell = kNone;
	bool may_be_flat = false;
	for (int f = 0; f < faces.size(); ++f)
	{
		Vec3 previous = grid.point(faces[f].back());
		for (const PointId p : faces[f])
		{
			const Vec3 corner = grid.point(p);
			if (const double length = glm::length(corner - previous); length > 0.0)
				shortest_of_cell = std::min(shortest_of_cell, length);
			else
				may_be_flat = true;
			previous = corner;
		}
	}
	const Vec3 rounding = kUlps * storedUlp(grid) * greatest;
	return {glm::max(Vec3(kOfEdge * edge), glm::min(rounding, Vec3(kMaxOfEdge * edge))),
	        may_be_flat && isFlatAt(grid, faces, face) ? 0.0 : kMaxOfEdge * shortest_of_cell};
}

} // namespace vp::grid
