#pragma once

#include "write/atomic_file.h"
#include "write/slice_table.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkDataSetAttributes;
class vtkPolyData;

namespace vp::write
{

// What the .vtp writers have in common.

// A VTK array over memory that stays ours.
vtkSmartPointer<vtkDataArray> viewNumbers(const char* name, grid::NumberType type, int components, void* numbers,
                                          std::size_t bytes);

template <class Values>
vtkSmartPointer<vtkDataArray> viewValues(const char* name, grid::NumberType type, int components, Values& values)
{
	return viewNumbers(name, type, components, values.data(), values.size() * sizeof(values[0]));
}

void addColumns(std::vector<Column>& columns, vtkDataSetAttributes* attributes);

void writePolyData(vtkPolyData* data, AtomicFile& file);

} // namespace vp::write
