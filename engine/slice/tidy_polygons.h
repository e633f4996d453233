#pragma once

#include "slice/mesh.h"

namespace vp::slice
{

// Drops repeated vertices, and polygons without area. In a flat mesh the rest is turned to run counter-clockwise about
// `normal`; in others (see SheetMesh::flat) polygons keep their sense and `normal` means nothing.
void tidyPolygons(SheetMesh& mesh, const Vec3& normal = Vec3(0.0));

// What the emission of a mesh leaves to the steps that look at it as a whole.
struct MeshDoubts
{
	bool at_points = false; // vertices lie at grid points, so several may lie at one
	bool slivers = false;   // polygons may have no area, or repeat a vertex

	MeshDoubts operator|(const MeshDoubts& other) const
	{
		return {at_points || other.at_points, slivers || other.slivers};
	}
};

// Turns a polygon of a flat mesh to run counter-clockwise about `normal`. One that tidyPolygons() may have to do with
// is left as it is, and the result is false.
bool turnPolygon(const SheetMesh& mesh, const Vec3& normal, std::span<std::uint32_t> polygon);

} // namespace vp::slice
