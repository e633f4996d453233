#pragma once

#include <vtkType.h>

#include <array>
#include <span>
#include <string_view>

namespace vp::reader::meshes
{

// A kind of cell of AVS UCD. Its place in ucdCells() is its number in binary files.
struct UcdCell
{
	std::string_view name;
	int type;
	vtkIdType corners;
};

std::span<const UcdCell> ucdCells();

// From AVS's order of corners to VTK's: AVS has the tip of a pyramid first, and the upper face of prisms and hexahedra
// before the lower one.
void turnUcdCell(int type, std::array<vtkIdType, 8>& corners);

} // namespace vp::reader::meshes
