#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

class vtkPointSet;

// The two-dimensional cells of a data set as polygons over their corners, for the manifest; null where there are none.
nlohmann::json describePolygons(ArrayWriter& writer, vtkPointSet* data);
