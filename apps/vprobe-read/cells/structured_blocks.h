#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

#include <array>

class vtkDataArray;
class vtkImageData;
class vtkMatrix3x3;
class vtkRectilinearGrid;
class vtkStructuredGrid;
class vtkPoints;

namespace vp::reader::cells
{

// Returns true if the axes of an image lie along x, y and z, up to their signs.
bool isAxisAligned(vtkMatrix3x3* direction);

// These return the part of a block's description that places its points.
nlohmann::json describeImage(arrays::Writer& writer, vtkImageData* image);
// Describes a piece of an image whose subscripts begin with `first` as a rectilinear grid.
nlohmann::json describeImageOf(arrays::Writer& writer, vtkImageData* piece, const std::array<int, 3>& first);
nlohmann::json describeRectilinear(arrays::Writer& writer, vtkRectilinearGrid* grid);
nlohmann::json describeCurvilinear(arrays::Writer& writer, vtkStructuredGrid* grid);

// Writes coordinates as float32 or float64, whatever type they had.
nlohmann::json writeCoordinates(arrays::Writer& writer, vtkPoints* points);

} // namespace vp::reader::cells
