#include "tree_leaves.h"

#include <vtkDoubleArray.h>
#include <vtkHyperTreeGrid.h>
#include <vtkHyperTreeGridNonOrientedGeometryCursor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>
#include <vector>

namespace vp::reader::vtk
{

namespace
{

struct TreeLeaf
{
	std::array<double, 3> lo, size;
};

void addLeaves(vtkHyperTreeGridNonOrientedGeometryCursor* cursor, std::vector<TreeLeaf>& leaves)
{
	if (cursor->IsMasked())
		return;
	if (!cursor->IsLeaf())
	{
		const int children = cursor->GetNumberOfChildren();
		for (int child = 0; child < children; ++child)
		{
			cursor->ToChild(static_cast<unsigned char>(child));
			addLeaves(cursor, leaves);
			cursor->ToParent();
		}
		return;
	}
	const double* lo = cursor->GetOrigin();
	const double* size = cursor->GetSize();
	leaves.push_back({{lo[0], lo[1], lo[2]}, {size[0], size[1], size[2]}});
}

} // namespace

bool setLeafPoints(vtkHyperTreeGrid* trees, vtkUnstructuredGrid* leaves)
{
	std::vector<TreeLeaf> boxes;
	vtkNew<vtkHyperTreeGridNonOrientedGeometryCursor> cursor;
	vtkHyperTreeGrid::vtkHyperTreeGridIterator iterator;
	trees->InitializeTreeIterator(iterator);
	for (vtkIdType index = 0; iterator.GetNextTree(index);)
	{
		trees->InitializeNonOrientedGeometryCursor(cursor, index);
		addLeaves(cursor, boxes);
	}
	if (static_cast<vtkIdType>(boxes.size()) != leaves->GetNumberOfCells())
		return false;
	vtkNew<vtkDoubleArray> places;
	places->SetNumberOfComponents(3);
	places->SetNumberOfTuples(leaves->GetNumberOfPoints());
	places->Fill(0.0);
	for (vtkIdType cell = 0; cell < leaves->GetNumberOfCells(); ++cell)
	{
		const TreeLeaf& box = boxes[static_cast<std::size_t>(cell)];
		vtkIdType count = 0;
		const vtkIdType* corners = nullptr;
		leaves->GetCellPoints(cell, count, corners);
		if (count != 8)
			return false;
		for (int corner = 0; corner < 8; ++corner)
		{
			std::array<double, 3> rounded;
			leaves->GetPoint(corners[corner], rounded.data());
			for (int axis = 0; axis < 3; ++axis)
			{
				const auto a = static_cast<std::size_t>(axis);
				const double place = box.lo[a] + (corner >> axis & 1 ? box.size[a] : 0.0);
				if (std::abs(place - rounded[a]) > std::abs(place) * 0x1p-22)
					return false;
				places->SetTypedComponent(corners[corner], axis, place);
			}
		}
	}
	vtkNew<vtkPoints> points;
	points->SetData(places);
	leaves->SetPoints(points);
	return true;
}

} // namespace vp::reader::vtk
