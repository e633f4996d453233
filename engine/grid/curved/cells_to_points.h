#pragma once

#include "grid/block.h"

#include <vector>

namespace vp::grid
{

/// Returns the fields of a block with arrays of points in place of those of cells: at each point the mean of the cells
/// that have it, as vtkCellDataToPointData has it. NaN does not count, nor do hidden cells and those without a volume;
/// a point without any other has NaN. Linear parts of one cell of the file count once. Each block is taken for itself.
/// Names of categories stay in the cells, and so does an array whose name an array of points has.
///
/// The result is in single precision if the array was, else in double. Throws WrongPoint if a cell names a point that
/// there is not.
std::vector<Field> fieldsAtPoints(const Block& block, std::vector<Field> fields);

} // namespace vp::grid
