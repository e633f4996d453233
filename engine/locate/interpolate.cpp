#include "locate/interpolate.h"

#include "locate/fan_weights.h"
#include "locate/shape_place.h"

#include <algorithm>
#include <cmath>

namespace vp::locate
{

namespace
{

using grid::CellShape;
using grid::kMaxShapePoints;

// The shape functions at one place of a cell's own coordinates, and their derivatives.
struct ShapeFunctions
{
	std::array<double, kMaxShapePoints> value{};
	std::array<Vec3, kMaxShapePoints> slope{};
};

ShapeFunctions tetrahedronAt(const Vec3& u)
{
	return {{1.0 - u.x - u.y - u.z, u.x, u.y, u.z},
	        {Vec3(-1.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)}};
}

// In a = r (1 - t), b = s (1 - t) and t of VTK's r, s, t: in those the functions have no slope at the tip, in these
// they stay as they are all along a line to it, and are linear over a base that is a parallelogram.
ShapeFunctions pyramidAt(const Vec3& u)
{
	const double below = 1.0 - u.z;
	const double r = below == 0.0 ? 0.5 : u.x / below;
	const double s = below == 0.0 ? 0.5 : u.y / below;
	const double both = r * u.y;
	const Vec3 slope(s, r, r * s);
	return {{below - u.x - u.y + both, u.x - both, both, u.y - both, u.z},
	        {Vec3(-1.0, -1.0, -1.0) + slope, Vec3(1.0, 0.0, 0.0) - slope, slope, Vec3(0.0, 1.0, 0.0) - slope,
	         Vec3(0.0, 0.0, 1.0)}};
}

ShapeFunctions wedgeAt(const Vec3& u)
{
	const std::array<double, 3> corner{1.0 - u.x - u.y, u.x, u.y};
	constexpr std::array<glm::dvec2, 3> kSlope{{{-1.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}}};
	ShapeFunctions at;
	for (int i = 0; i < 6; ++i)
	{
		const int c = i % 3;
		const double side = i < 3 ? 1.0 - u.z : u.z;
		at.value[i] = corner[c] * side;
		at.slope[i] = Vec3(kSlope[c] * side, i < 3 ? -corner[c] : corner[c]);
	}
	return at;
}

ShapeFunctions hexahedronAt(const Vec3& u)
{
	ShapeFunctions at;
	for (int i = 0; i < 8; ++i)
	{
		const bool x = i % 4 == 1 || i % 4 == 2;
		const bool y = i % 4 >= 2;
		const bool z = i >= 4;
		const Vec3 f(x ? u.x : 1.0 - u.x, y ? u.y : 1.0 - u.y, z ? u.z : 1.0 - u.z);
		at.value[i] = f.x * f.y * f.z;
		at.slope[i] = {(x ? 1.0 : -1.0) * f.y * f.z, (y ? 1.0 : -1.0) * f.x * f.z, (z ? 1.0 : -1.0) * f.x * f.y};
	}
	return at;
}

ShapeFunctions functionsAt(CellShape shape, const Vec3& u)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return tetrahedronAt(u);
	case CellShape::pyramid:
		return pyramidAt(u);
	case CellShape::wedge:
		return wedgeAt(u);
	default:
		return hexahedronAt(u);
	}
}

// points, place: relative to the cell's first point, so that a cell of 1e-6 far from zero keeps its digits.
struct Residual
{
	Vec3 missing;              // from where u lies to the place
	std::array<Vec3, 3> along; // the map's derivatives there
};

Residual residualAt(CellShape shape, std::span<const Vec3> points, const Vec3& place, const Vec3& u)
{
	const ShapeFunctions at = functionsAt(shape, u);
	Residual residual{place, {Vec3(0.0), Vec3(0.0), Vec3(0.0)}};
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		residual.missing -= at.value[i] * points[i];
		for (int axis = 0; axis < 3; ++axis)
			residual.along[axis] += at.slope[i][axis] * points[i];
	}
	return residual;
}

} // namespace

std::optional<ShapeWeights> shapeWeights(CellShape shape, std::span<const Vec3> points, const Vec3& place)
{
	// Steps square the error: from the middle of a sound cell 4 or 5 do.
	constexpr int kMaxSteps = 24;
	constexpr double kStill = 1e-10;    // after such a short step, only rounding remains
	constexpr double kTrembles = 1e-6;  // in thin cells, rounding keeps steps this long
	constexpr double kFar = 1e3;        // in cell sizes: the place is not in this cell
	constexpr double kRounding = 1e-12; // share of the cell's size
	std::array<Vec3, kMaxShapePoints> near{};
	double size = glm::length(place - points[0]);
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		near[i] = points[i] - points[0];
		size = std::max(size, glm::length(near[i]));
	}
	const auto residual = [&](const Vec3& u) {
		return residualAt(shape, {near.data(), points.size()}, place - points[0], u);
	};
	Vec3 u = middleOf(shape);
	double length = 1.0;
	for (int step = 0; step < kMaxSteps && length > kStill; ++step)
	{
		const Residual at = residual(u);
		const Vec3 move = solve(at.along, at.missing);
		u += move;
		length = glm::length(move);
		if (!(glm::length(u) < kFar)) // NaN too
			return std::nullopt;
	}
	// Near a collapsed edge rounding may end in a place of its own.
	if (length > kTrembles || glm::length(residual(u).missing) > kRounding * size)
		return std::nullopt;
	return ShapeWeights{functionsAt(shape, u).value, faceDepths(shape, u).least()};
}

void weighCell(const grid::Block& block, CellId cell, const Vec3& place, CellWeights& found)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    if (const CellShape shape = grid.shape(cell); shape != CellShape::polyhedron)
		    {
			    const grid::CellPoints ids = grid.cellPoints(cell);
			    std::array<Vec3, kMaxShapePoints> points;
			    for (int i = 0; i < ids.size; ++i)
				    points[i] = grid.point(ids.id[i]);
			    if (const auto weights = shapeWeights(shape, {points.data(), std::size_t(ids.size)}, place))
			    {
				    found.points.assign(ids.begin(), ids.end());
				    found.weights.assign(weights->weight.begin(), weights->weight.begin() + ids.size);
				    found.depth = weights->depth;
				    return;
			    }
		    }
		    weighFan(grid, cell, place, found);
	    },
	    block.grid);
}

void weighCellByTetrahedra(const grid::Block& block, CellId cell, const Vec3& place, CellWeights& found)
{
	std::visit([&](const auto& grid) { weighFan(grid, cell, place, found); }, block.grid);
}

} // namespace vp::locate
