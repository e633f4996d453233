#pragma once

#include "mesh/sheet_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::measure
{

// Where a line meets a side of a polygon: at a + part (b - a), `t` of the line's length from its start, which is below
// 0 or above 1 beyond its ends.
struct SideCrossing
{
	std::uint32_t a; // vertices of the mesh; a lies more to the left of the line
	std::uint32_t b;
	double part;
	double t;
};

// The part of a line in a polygon, from `from` to `to`, within 0..1; values are linear from `enter` to `leave`.
struct LinePiece
{
	std::uint32_t polygon;
	double from;
	double to;
	SideCrossing enter;
	SideCrossing leave;

	// 0 at enter, 1 at leave.
	double along(double t) const { return (t - enter.t) / (leave.t - enter.t); }
};

// The polygons along the line from a to b (not the same), places in the plane like `points` (planePoints()), in order
// and without overlap: where polygons lie over each other the one that is entered first goes before. Along sides that
// lie in the line the polygon at its right goes before the one at its left.
std::vector<LinePiece> alongLine(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points, const glm::dvec2& a,
                                 const glm::dvec2& b);

// The space between two pieces is a gap if it is longer than this share of the line.
constexpr double kLineGap = 1e-7;

} // namespace vp::measure
