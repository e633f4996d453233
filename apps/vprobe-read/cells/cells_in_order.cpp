#include "cells_in_order.h"

#include "source_cell.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

namespace vp::reader::cells
{

void CellsInOrder::add(vtkIdType cell, std::uint8_t type, CellKind& kind, vtkIdList* points)
{
	if (!kind.order.isDoubtful())
		return;
	doubtful_.push_back({cell, type});
	nodes_.clear();
	for (vtkIdType n = 0; n < points->GetNumberOfIds(); ++n)
	{
		Vec3 at;
		grid_->GetPoint(points->GetId(n), &at.x);
		nodes_.push_back(at);
	}
	kind.order.weigh(nodes_);
}

void CellsInOrder::apply()
{
	vtkNew<vtkIdList> ids;
	vtkNew<vtkIdList> ordered;
	for (const auto& [cell, type] : doubtful_)
	{
		grid_->GetCells()->GetCellAtId(cell, ids);
		const NodeOrder& order = source_.enter(cell, type, ids).order;
		if (order.isVtk())
			continue;
		ordered->SetNumberOfIds(ids->GetNumberOfIds());
		for (vtkIdType n = 0; n < ids->GetNumberOfIds(); ++n)
			ordered->SetId(n, ids->GetId(order.best()[static_cast<std::size_t>(n)]));
		grid_->GetCells()->ReplaceCellAtId(cell, ordered);
	}
}

} // namespace vp::reader::cells
