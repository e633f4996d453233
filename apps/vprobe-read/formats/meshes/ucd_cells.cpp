#include "ucd_cells.h"

#include <vtkCellType.h>

namespace vp::reader::meshes
{

std::span<const UcdCell> ucdCells()
{
	static constexpr UcdCell cells[] = {{"pt", VTK_VERTEX, 1},   {"line", VTK_LINE, 2},     {"tri", VTK_TRIANGLE, 3},
	                                    {"quad", VTK_QUAD, 4},   {"tet", VTK_TETRA, 4},     {"pyr", VTK_PYRAMID, 5},
	                                    {"prism", VTK_WEDGE, 6}, {"hex", VTK_HEXAHEDRON, 8}};
	return cells;
}

void turnUcdCell(int type, std::array<vtkIdType, 8>& corners)
{
	const std::array<vtkIdType, 8> c = corners;
	if (type == VTK_PYRAMID)
		corners = {c[1], c[2], c[3], c[4], c[0], 0, 0, 0};
	else if (type == VTK_WEDGE)
		corners = {c[3], c[4], c[5], c[0], c[1], c[2], 0, 0};
	else if (type == VTK_HEXAHEDRON)
		corners = {c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]};
}

} // namespace vp::reader::meshes
