#include "patch_polygons.h"

#include "structured_blocks.h"

#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointSet.h>

#include <algorithm>
#include <vector>

namespace vp::reader::cells
{

namespace
{

// Returns how many of a cell's points are its corners, which come first. Returns 0 if the cell is not a polygon.
vtkIdType cornersOf(int type, vtkIdType points)
{
	switch (type)
	{
	case VTK_TRIANGLE:
	case VTK_QUAD:
	case VTK_POLYGON:
		return points;
	case VTK_QUADRATIC_TRIANGLE:
	case VTK_BIQUADRATIC_TRIANGLE:
		return 3;
	case VTK_QUADRATIC_QUAD:
	case VTK_BIQUADRATIC_QUAD:
	case VTK_QUADRATIC_LINEAR_QUAD:
		return 4;
	default:
		return 0;
	}
}

} // namespace

nlohmann::json describePolygons(arrays::Writer& writer, vtkPointSet* data)
{
	std::vector<std::int64_t> starts = {0};
	std::vector<std::int64_t> corners;
	vtkNew<vtkIdList> points;
	for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
	{
		data->GetCellPoints(cell, points);
		const vtkIdType count =
		    std::min(cornersOf(data->GetCellType(cell), points->GetNumberOfIds()), points->GetNumberOfIds());
		for (vtkIdType i = 0; i < count; ++i)
			corners.push_back(points->GetId(i));
		if (count > 0)
			starts.push_back(static_cast<std::int64_t>(corners.size()));
	}
	if (corners.empty())
		return nullptr;
	return {{"coordinates", writeCoordinates(writer, data->GetPoints())},
	        {"starts", arrays::writeInt64(writer, std::span<const std::int64_t>(starts))},
	        {"corners", arrays::writeInt64(writer, std::span<const std::int64_t>(corners))}};
}

} // namespace vp::reader::cells
