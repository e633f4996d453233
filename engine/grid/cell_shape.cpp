#include "grid/cell_shape.h"

#include <initializer_list>

namespace vp::grid
{

namespace
{

using Ids = std::initializer_list<std::uint8_t>;

constexpr ShapeTopology makeTopology(int points, std::initializer_list<Ids> faces, std::initializer_list<Ids> edges)
{
	ShapeTopology shape;
	shape.points = points;
	for (const Ids& face : faces)
	{
		int corner = 0;
		for (const std::uint8_t p : face)
			shape.face[shape.faces][corner++] = p;
		shape.face_size[shape.faces++] = static_cast<std::uint8_t>(corner);
	}
	for (const Ids& edge : edges)
		shape.edge[shape.edges++] = {*edge.begin(), *(edge.begin() + 1)};
	return shape;
}

} // namespace

// The numbers of vtkTetra, vtkPyramid, vtkWedge and vtkHexahedron (VTK 9). A wedge's first triangle faces away from
// its second, unlike the first quad of a hexahedron, whose points VTK lists the other way round.
constinit const std::array<ShapeTopology, kTableShapes> kTopologies = {
    makeTopology(4, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}),
    makeTopology(5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                 {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}),
    makeTopology(6, {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}},
                 {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}),
    makeTopology(8, {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}},
                 {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}})};

int ShapeTopology::edgeBetween(int a, int b) const
{
	for (int e = 0; e < edges; ++e)
		if ((edge[e][0] == a && edge[e][1] == b) || (edge[e][0] == b && edge[e][1] == a))
			return e;
	return -1;
}

const char* shapeName(CellShape shape)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return "tetrahedron";
	case CellShape::pyramid:
		return "pyramid";
	case CellShape::wedge:
		return "wedge";
	case CellShape::hexahedron:
		return "hexahedron";
	case CellShape::polyhedron:
		return "polyhedron";
	}
	return "unknown";
}

} // namespace vp::grid
