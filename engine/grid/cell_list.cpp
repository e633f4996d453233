#include "grid/cell_list.h"

namespace vp::grid
{

int vtkDimension(std::uint8_t vtk_type)
{
	// By VTK's cell type number; 9: no such type.
	static constexpr char dimension[] = "0001122222" // 0: empty, vertices, lines, triangle, strip, polygon, pixel, quad
	                                    "3333333999" // 10: tetrahedron … hexagonal prism
	                                    "9122333323" // 20: quadratic edge, triangle, quad, tetrahedron …
	                                    "2333212399" // 30: … cubic line, quadratic polygon, triquadratic pyramid
	                                    "9339999999" // 40: convex point set, polyhedron
	                                    "9122233999" // 50: parametric
	                                    "1222333312" // 60: higher order; Lagrange from 68
	                                    "2333312233" // 70: Bezier from 75
	                                    "33";
	if (vtk_type >= sizeof(dimension) - 1 || dimension[vtk_type] == '9')
		return -1;
	return dimension[vtk_type] - '0';
}

bool isSliceable(std::uint8_t vtk_type)
{
	return (vtk_type >= 10 && vtk_type <= 14) || vtk_type == 42;
}

} // namespace vp::grid
