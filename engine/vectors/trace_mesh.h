#pragma once

#include "mesh/sheet_mesh.h"
#include "vectors/curves.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::vectors
{

// Curves as polygons in world coordinates, for drawing: triangles and quads, closed but for ribbons.
struct TraceMesh
{
	mesh::SheetMesh mesh;       // positions and polygons, nothing else
	std::vector<double> values; // per vertex, of its point of the curve

	TraceMesh() { mesh.polygon_starts.push_back(0); }
	std::uint32_t addVertex(const Vec3& place, double value); // gives its number
	void addPolygon(std::span<const std::uint32_t> vertices);
};

// What follows adds each curve to a mesh. values: per point of the curves. Widths are > 0, in the grid's units.

// Round, with flat ends.
void addTubes(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh);

// Thin tubes, of fewer sides.
void addLines(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh);

// Thin tubes that end in a cone, where the particle comes to last. Of a short curve both are smaller.
void addArrows(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh);

// Strips. wished: where the strip's width is to point at a launch, as far as it can. turns: how far it is turned about
// the curve beyond what the curve's own bends bring, in radians, right-handed, per point of the curves; empty: nowhere.
void addRibbons(const Curves& curves, std::span<const double> values, double width, const Vec3& wished,
                std::span<const double> turns, TraceMesh& mesh);

} // namespace vp::vectors
