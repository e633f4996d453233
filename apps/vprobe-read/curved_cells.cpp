#include "curved_cells.h"

#include "cell_lists.h"
#include "grid/curved_cells.h"
#include "read/cell_types.h"
#include "refusal.h"
#include "source_cell.h"
#include "visible_cells.h"

#include <vtkCellTypes.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <string_view>

using namespace vp::read;

namespace
{

std::string_view shortName(std::uint8_t type)
{
	std::string_view name = vtkCellTypes::GetClassNameFromTypeId(type);
	if (name.starts_with("vtk"))
		name.remove_prefix(3);
	return name;
}

} // namespace

bool keepsCurved(vtkUnstructuredGrid* grid, double tolerance)
{
	if (!grid->GetPoints() || !grid->GetCells() || !grid->GetCellTypesArray())
		return false;
	refuseBadLists(grid);
	const vtkUnsignedCharArray* types = grid->GetCellTypesArray();
	const vtkIdType count = grid->GetNumberOfCells();
	bool any = false;
	for (vtkIdType c = 0; c < count && !any; ++c)
		any = isCurved(types->GetValue(c));
	if (!any)
		return false;
	vtkUnsignedCharArray* ghosts = ghostMarks(grid);
	for (vtkIdType c = 0; c < count; ++c)
	{
		const std::uint8_t type = types->GetValue(c);
		if (cellDimension(type) < 3 || (ghosts && (ghosts->GetValue(c) & kHiddenCellBits)))
			continue;
		const vtkIdType points = grid->GetCells()->GetCellSize(c);
		const bool tetrahedron = type == vp::grid::kQuadraticTetra || type == vp::grid::kLagrangeTetra;
		if (tetrahedron ? points == vp::grid::kQuadraticTetraNodes : slicedCellSize(type) > 0)
			continue;
		if (type == vp::grid::kQuadraticTetra)
			throw damaged(fmt::format("cell {} of type {} lists {} points", c, type, points));
		throw Refusal(fmt::format("--refine {}: a tolerance refines quadratic tetrahedra, and cell {} is a {} of {} "
		                          "points; give a level, such as --refine 1",
		                          tolerance, c, shortName(type), points));
	}
	return true;
}
