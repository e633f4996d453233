#pragma once

#include "array_writer.h"

#include <nlohmann/json.hpp>

class vtkDataArray;
class vtkImageData;
class vtkRectilinearGrid;
class vtkStructuredGrid;
class vtkPoints;

// The part of a block's description that places its points.
nlohmann::json describeImage(ArrayWriter& writer, vtkImageData* image);
nlohmann::json describeRectilinear(ArrayWriter& writer, vtkRectilinearGrid* grid);
nlohmann::json describeCurvilinear(ArrayWriter& writer, vtkStructuredGrid* grid);

// Coordinates as float32 or float64, whatever they were.
nlohmann::json writeCoordinates(ArrayWriter& writer, vtkPoints* points);
