#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <string>
#include <vector>

class vtkDoubleArray;

namespace vp::reader::wrapped
{

// Looks for what VTK's reader takes for there: variables of elements that the file's table names and that are missing,
// which it fills with nothing, and what tells of the elements, and their nodes, without which it crashes. Throws a
// Refusal for them.
void refuseMissingExodus(const std::string& file);

// Variables of nodes that lie one by one in a file that is not of the kind of large ones, as meshio writes it: VTK's
// reader would not find them, and leave their values as the memory has them.
bool hasOddExodusNodes(const std::string& file);

// Those variables at a step, with a value for each node of the file.
std::vector<vtkSmartPointer<vtkDoubleArray>> oddExodusNodes(const std::string& file, std::size_t step);

// The times of its steps, in the order of the file.
std::vector<double> exodusTimes(const std::string& file);

// Names that more than one variable of nodes, or of elements, has: VTK's reader gives one of them.
std::vector<std::string> repeatedExodusNames(const std::string& file);

} // namespace vp::reader::wrapped
