#pragma once

#include "base/vec.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <functional>
#include <ostream>
#include <vector>

class vtkUnstructuredGrid;

// A kind of cell that is cut into linear ones on reading.
struct CurvedKind
{
	const char* name;
	std::uint8_t type; // VTK's
	int points;
	std::array<int, 3> degrees = {0, 0, 0}; // written where they differ between axes
};

std::ostream& operator<<(std::ostream& out, const CurvedKind& kind);

const std::vector<CurvedKind>& curvedKinds();

// A box of 2 x 2 x 2 blocks, each one cell or several (2 wedges, 6 tetrahedra or pyramids), conforming. Point array "f"
// is sampleValue(), "n" its nearest integer, cell array "id" the cell's number. `shape` moves the points.
constexpr vp::Vec3 kCurvedBox{2.0, 3.0, 5.0};
vtkSmartPointer<vtkUnstructuredGrid> curvedMesh(const CurvedKind& kind,
                                                const std::function<vp::Vec3(vp::Vec3)>& shape = {});

// One cell, in the coordinates of its reference shape.
vtkSmartPointer<vtkUnstructuredGrid> curvedCell(const CurvedKind& kind);

void writeGrid(vtkUnstructuredGrid* grid, const std::string& path);
