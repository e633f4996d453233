#pragma once

#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"

#include <span>

namespace vp::mesh
{

// Says what happens to the polygons that contain a corner of the window.
enum class Corners
{
	keep, // the corner is a vertex; its value is linear between the rim's vertices beside it
	skip  // they are left out
};

// A side to clip at: what lies at least `least` along the axis from an origin is kept.
struct ClipSide
{
	Vec3 axis;
	double least;
};
constexpr std::size_t kMaxClipSides = 8;

// The part of a mesh within all of the sides, at most kMaxClipSides, whose origin is one.
// Vertices on the rim lie on the edges of polygons, with values linear along them, and are shared like any other.
// Sutherland and Hodgman's. A polygon that is not convex may leave several parts, each a polygon of the same cell.
void clipToSides(const Vec3& origin, std::span<const ClipSide> sides, Corners corners, SheetMesh& mesh);

// The part of a mesh within the window of the sheet it is the cut of (placed, without fx, see probe::content()).
void clipToWindow(const probe::Sheet& content, Corners corners, SheetMesh& mesh);

} // namespace vp::mesh
