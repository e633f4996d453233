#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vp::grid
{

// The shapes that have a case table, and the polyhedron, whose faces are listed for each cell. A VTK voxel is stored as
// a hexahedron.
enum class CellShape : std::uint8_t
{
	tetrahedron,
	pyramid,
	wedge,
	hexahedron,
	polyhedron
};

constexpr int kTableShapes = 4; // the shapes before polyhedron
constexpr int kMaxShapePoints = 8;
constexpr int kMaxShapeFaces = 6;
constexpr int kMaxShapeEdges = 12;

// Faces and edges of a shape as indices into its points, in VTK's numbering (vtkTetra, vtkPyramid, vtkWedge,
// vtkHexahedron); a face's points run counter-clockwise seen from outside.
struct ShapeTopology
{
	int points = 0;
	int faces = 0;
	int edges = 0;
	std::array<std::uint8_t, kMaxShapeFaces> face_size{};
	std::array<std::array<std::uint8_t, 4>, kMaxShapeFaces> face{};
	std::array<std::array<std::uint8_t, 2>, kMaxShapeEdges> edge{};

	std::span<const std::uint8_t> facePoints(int f) const { return {face[f].data(), face_size[f]}; }
	int edgeBetween(int a, int b) const; // number of the edge; -1 if there is none between a and b
};

extern const std::array<ShapeTopology, kTableShapes> kTopologies;

// Returns the topology of a shape that has a case table.
inline const ShapeTopology& topology(CellShape shape)
{
	return kTopologies[static_cast<std::size_t>(shape)];
}

const char* shapeName(CellShape shape);

} // namespace vp::grid
