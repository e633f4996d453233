#pragma once

#include <string>
#include <vector>

class vtkFieldData;

namespace vp::reader::manifest
{

class Writer;

// Returns a name that none of the arrays has: `name`, or "name 2" and so on, with a warning, if it is taken. VTK would
// drop the first of two arrays with the same name.
std::string ownName(vtkFieldData* arrays, const std::string& name, Writer& manifest);

// Does the same for all names of a list.
void makeOwnNames(std::vector<std::string>& names, Writer& manifest);

} // namespace vp::reader::manifest
