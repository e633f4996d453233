#pragma once

#include "vprobe-read/arrays/array_writer.h"

#include <nlohmann/json.hpp>

class vtkPointSet;

namespace vp::reader::cells
{

// Describes the two-dimensional cells of a data set as polygons over their corners. Returns null if there are none.
nlohmann::json describePolygons(arrays::Writer& writer, vtkPointSet* data);

} // namespace vp::reader::cells
