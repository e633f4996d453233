#pragma once

#include <string>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace vp::reader::manifest
{

class Writer;

// Adds an array. If its name is taken, or empty, it gets a name of its own, with a warning: VTK would keep only one of
// two arrays that have the same name. association: "point" or "cell".
void addUnderOwnName(vtkDataSetAttributes* fields, vtkAbstractArray* array, const char* association, Writer& manifest);

} // namespace vp::reader::manifest
