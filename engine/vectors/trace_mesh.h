#pragma once

#include "mesh/sheet_mesh.h"
#include "vectors/curves.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::vectors
{

// Curves as polygons in world coordinates, for drawing. They are triangles and quads. All forms are closed, except
// ribbons.
struct TraceMesh
{
	mesh::SheetMesh mesh;       // positions and polygons, nothing else
	std::vector<double> values; // per vertex: the value at its point of the curve

	TraceMesh() { mesh.polygon_starts.push_back(0); }
	std::uint32_t addVertex(const Vec3& place, double value); // returns its number
	void addPolygon(std::span<const std::uint32_t> vertices);
};

// These add each curve to a mesh. values: one for each point of the curves. Widths are > 0, in the grid's units.

// Adds round tubes with flat ends.
void addTubes(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh);

// Adds thin tubes with fewer sides.
void addLines(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh);

// Adds thin tubes that end in a cone at the last place of the particle. On a short curve both are smaller.
void addArrows(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh);

// Adds strips. wished: the direction of the strip's width at a launch, as far as possible. turns: for each point of the
// curves the angle by which the strip is turned about the curve, in radians, right-handed, in addition to the bends of
// the curve. Empty: no turns.
void addRibbons(const Curves& curves, std::span<const double> values, double width, const Vec3& wished,
                std::span<const double> turns, TraceMesh& mesh);

} // namespace vp::vectors
