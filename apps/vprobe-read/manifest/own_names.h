#pragma once

#include <string>
#include <vector>

class ManifestWriter;
class vtkFieldData;

// A name that none of the arrays has: `name`, or "name 2" and so on where there is one already, with a warning. VTK
// would drop the first of them.
std::string ownName(vtkFieldData* arrays, const std::string& name, ManifestWriter& manifest);

// The same for all names of a list.
void makeOwnNames(std::vector<std::string>& names, ManifestWriter& manifest);
