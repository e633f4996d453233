#pragma once

#include <string>

class ManifestWriter;
class vtkAbstractArray;
class vtkDataSetAttributes;

// Adds an array. If its name is taken, or empty, it gets one of its own, and a warning tells it: VTK would keep one of
// two arrays that have the same name. association: "point" or "cell".
void addUnderOwnName(vtkDataSetAttributes* fields, vtkAbstractArray* array, const char* association,
                     ManifestWriter& manifest);
