#include "grid/unstructured.h"

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

int UnstructuredGrid::faceCount(CellId c) const
{
	if (!isPolyhedron(c))
		return topology(shape(c)).faces;
	const std::uint32_t number = record(c)[0];
	return static_cast<int>(polyhedron_faces_[number + 1] - polyhedron_faces_[number]);
}

void UnstructuredGrid::cellFaces(CellId c, CellFaces& faces) const
{
	faces.clear();
	if (!isPolyhedron(c))
		return shapeFaces(shape(c), cellPoints(c), faces);
	const std::uint32_t number = record(c)[0];
	for (std::uint32_t f = polyhedron_faces_[number]; f < polyhedron_faces_[number + 1]; ++f)
		faces.add({face_points_.data() + face_points_start_[f], face_points_start_[f + 1] - face_points_start_[f]});
}

std::size_t UnstructuredGrid::geometryBytes() const
{
	return points_.bytes() + 4 * (cell_count_ * std::size_t(width_) + polyhedron_faces_.capacity() +
	                              face_points_start_.capacity() + face_points_.capacity());
}

std::size_t UnstructuredGrid::adjacencyBytes() const
{
	std::size_t sum = 4 * (cell_count_ * std::size_t(face_width_) + polyhedron_neighbors_.capacity() +
	                       source_points_.capacity() + source_cells_.capacity());
	for (const std::vector<CellId>& cells : several_)
		sum += sizeof(cells) + 4 * cells.capacity();
	return sum;
}

} // namespace vp::grid
