#pragma once

#include "random_probe.h"

#include "mesh/sheet_mesh.h"

namespace vp::render::test
{

// A surface as the test knows it. Its polygons are flat and convex, of up to six corners, with values between 0 and 1
// at the vertices or of the polygons.
struct KnownSurface
{
	Surface drawing; // without polygons, in the colors of its values
	mesh::SheetMesh mesh;
	std::vector<double> vertex_values;
	std::vector<double> polygon_values;
};

// Corners that are where a vertex is already are that vertex.
void addPolygon(mesh::SheetMesh& mesh, const std::vector<Vec3>& corners);

// Returns the polygons of the sheet as a surface with the same look. The window is left out.
KnownSurface asSurface(const KnownSheet& known);

// A closed surface of triangles about the origin, bulged at random so that it is seen through itself more than twice,
// and of any opacity.
KnownSurface randomBlob(std::mt19937& random);

// The surface with its polygons on the device.
Surface onDevice(gpu::Device& device, const KnownSurface& known);

} // namespace vp::render::test
