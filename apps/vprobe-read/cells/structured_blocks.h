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

// Returns true if the axes of an image lie along x, y and z, up to their signs.
bool isAxisAligned(vtkMatrix3x3* direction);

// These return the part of a block's description that places its points.
nlohmann::json describeImage(ArrayWriter& writer, vtkImageData* image);
// Describes a piece of an image whose subscripts begin with `first` as a rectilinear grid.
nlohmann::json describeImageOf(ArrayWriter& writer, vtkImageData* piece, const std::array<int, 3>& first);
nlohmann::json describeRectilinear(ArrayWriter& writer, vtkRectilinearGrid* grid);
nlohmann::json describeCurvilinear(ArrayWriter& writer, vtkStructuredGrid* grid);

// Writes coordinates as float32 or float64, whatever type they had.
nlohmann::json writeCoordinates(ArrayWriter& writer, vtkPoints* points);
