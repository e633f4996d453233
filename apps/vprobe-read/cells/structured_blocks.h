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

// Whether an image is turned away from x, y and z by no more than its axes' signs.
bool isAxisAligned(vtkMatrix3x3* direction);

// The part of a block's description that places its points.
nlohmann::json describeImage(ArrayWriter& writer, vtkImageData* image);
// Of a piece of an image whose subscripts begin with `first`: the axes of a rectilinear grid.
nlohmann::json describeImageOf(ArrayWriter& writer, vtkImageData* piece, const std::array<int, 3>& first);
nlohmann::json describeRectilinear(ArrayWriter& writer, vtkRectilinearGrid* grid);
nlohmann::json describeCurvilinear(ArrayWriter& writer, vtkStructuredGrid* grid);

// Coordinates as float32 or float64, whatever they were.
nlohmann::json writeCoordinates(ArrayWriter& writer, vtkPoints* points);
