#pragma once

#include "ensight_geometry.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

namespace vp::reader::meshes
{

// VTK's data sets of the parts, by their numbers. Numbers of a binary file stay single precision.
std::map<std::int64_t, vtkSmartPointer<vtkDataSet>> ensightGrids(const EnSightGeometry& geometry, bool is_binary);

// Adds values of all points or cells of a part.
void addEnSightArray(vtkDataSet* grid, const std::string& name, bool per_node, int components,
                     const std::vector<double>& values, bool is_binary);

} // namespace vp::reader::meshes
