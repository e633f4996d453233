#pragma once

#include "foam_case.h"

class ManifestWriter;
class vtkDataObject;

// Gives what VTK's reader made of a case the numbers of the case's files: places, fields of cells and points, and the
// values of points that the reader made from those of cells. VTK makes single precision of them all. Numbers that are
// not the rounded ones stay as they are; the manifest then has a warning.
void widenFoam(const FoamCase& files, vtkDataObject* output, ManifestWriter& manifest);
