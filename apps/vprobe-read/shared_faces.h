#pragma once

#include <string>
#include <vector>

class vtkUnstructuredGrid;

// VTK 9.4 and later write the faces of polyhedra once, and lists of them for each cell (.vtu 2.3). VTK 9.1 reads the
// cells of such files without faces. Adds them to the grid that it read from the pieces in these files, one behind the
// other. Does nothing for files without such lists.
void addSharedFaces(const std::vector<std::string>& files, vtkUnstructuredGrid* grid);
