#pragma once

#include "vprobe-read/text/xml_tree.h"

#include <vtkType.h>

#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace vp::reader::meshes
{

// Adds the cells of a topology to a grid that has its points. `stream`: their ids, which count from `first`.
void insertXdmfCells(const std::vector<vtkIdType>& stream, vtkIdType first, const std::string& type,
                     const text::XmlElement& topology, vtkUnstructuredGrid* grid);

// The same of cells of different types, each behind its number.
void insertMixedXdmfCells(const std::vector<vtkIdType>& stream, vtkIdType first, vtkUnstructuredGrid* grid);

} // namespace vp::reader::meshes
