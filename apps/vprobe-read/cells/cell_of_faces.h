#pragma once

#include <vtkType.h>

#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::cells
{

class GrownCells;

// A face by its corners, in order around it, seen from outside of the cell.
using FaceCorners = std::vector<vtkIdType>;

// Adds the cell that has these faces: as a tetrahedron, pyramid, wedge or hexahedron if it is one, or else as a
// polyhedron.
void addCellOfFaces(GrownCells& cells, std::span<const FaceCorners> faces);

} // namespace vp::reader::cells
