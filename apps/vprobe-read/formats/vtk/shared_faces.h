#pragma once

#include <cstdint>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace vp::reader::vtk
{

// The faces of the polyhedra of one piece, as VTK 9.4 and later keep them: each once, with lists of them for each cell.
struct SharedFaces
{
	std::uint64_t points = 0;
	std::uint64_t cells = 0;
	bool has_lists = false;
	// Corners of faces, and faces of cells; the ends of each list, without the 0 in front.
	std::vector<std::int64_t> corners, corner_ends, faces, face_ends;
};

// Gives the cells of a grid the faces of its pieces, which follow each other. Pieces without lists keep what they have.
// Throws a Refusal where the lists do not fit.
void setSharedFaces(const std::vector<SharedFaces>& pieces, vtkUnstructuredGrid* grid);

// VTK 9.1 reads the polyhedra of .vtu 2.3 without faces. Adds these to the grid that it read from the pieces in these
// files, one behind the other. Does nothing for files without such lists.
void addSharedFaces(const std::vector<std::string>& files, vtkUnstructuredGrid* grid);

} // namespace vp::reader::vtk
