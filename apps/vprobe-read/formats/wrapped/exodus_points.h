#pragma once

#include <string>

class vtkDataSet;
class vtkMultiBlockDataSet;

namespace vp::reader::wrapped
{

// True if VTK's reader would lose digits of the coordinates, for it makes single precision of them.
bool hasDoubleExodusPoints(const std::string& file);

// Gives the points the numbers that VTK's reader would give them, where they are all nodes of the file in order.
void numberExodusNodes(vtkDataSet* data);

// Gives the points the coordinates that the file has for their nodes. The data sets have the numbers of their nodes.
// False if the points of a data set are not the file's, whose points then stay as they are.
bool setExodusPoints(const std::string& file, vtkMultiBlockDataSet* objects);

} // namespace vp::reader::wrapped
