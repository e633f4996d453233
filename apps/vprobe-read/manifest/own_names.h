#pragma once

#include <string>
#include <vector>

class ManifestWriter;
class vtkFieldData;

// Returns a name that none of the arrays has: `name`, or "name 2" and so on, with a warning, if it is taken. VTK would
// drop the first of two arrays with the same name.
std::string ownName(vtkFieldData* arrays, const std::string& name, ManifestWriter& manifest);

// Does the same for all names of a list.
void makeOwnNames(std::vector<std::string>& names, ManifestWriter& manifest);
