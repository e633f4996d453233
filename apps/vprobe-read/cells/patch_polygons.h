#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

class vtkPointSet;

// Describes the two-dimensional cells of a data set as polygons over their corners. Returns null if there are none.
nlohmann::json describePolygons(ArrayWriter& writer, vtkPointSet* data);
