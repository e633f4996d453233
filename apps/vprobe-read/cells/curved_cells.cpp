#include "curved_cells.h"

#include "cell_lists.h"
#include "cells_in_order.h"
#include "collapsed_cells.h"
#include "grid/curved/curved_types.h"
#include "read/cell_types.h"
#include "source_cell.h"
#include "visible_cells.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

namespace vp::reader::cells
{

namespace
{

std::string_view shortName(std::uint8_t type)
{
	std::string_view name = vtkCellTypes::GetClassNameFromTypeId(type);
	if (name.starts_with("vtk"))
		name.remove_prefix(3);
	return name;
}

bool hasEqualCorners(std::uint8_t type, vtkIdList* ids)
{
	const auto corners =
	    std::min(ids->GetNumberOfIds(), static_cast<vtkIdType>(grid::topology(grid::cornerShape(type)).points));
	for (vtkIdType c = 1; c < corners; ++c)
		if (std::find(ids->begin(), ids->begin() + c, ids->GetId(c)) != ids->begin() + c)
			return true;
	return false;
}

void checkPoints(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* ids)
{
	for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
		if (ids->GetId(i) < 0 || ids->GetId(i) >= grid->GetNumberOfPoints())
			throw damaged(fmt::format("cell {} lists point {} of {}", cell, ids->GetId(i), grid->GetNumberOfPoints()));
}

// If a cell lists more points than its type has, keeps the first ones, as without a tolerance.
void trimLists(vtkUnstructuredGrid* grid)
{
	vtkCellArray* cells = grid->GetCells();
	vtkUnsignedCharArray* types = grid->GetCellTypesArray();
	const auto keptOf = [&](vtkIdType cell) -> vtkIdType
	{
		const std::uint8_t type = types->GetValue(cell);
		const vtkIdType fixed = grid::isCurved(type) ? grid::fixedNodes(type) : 0;
		return fixed > 0 ? std::min(fixed, cells->GetCellSize(cell)) : cells->GetCellSize(cell);
	};
	vtkIdType cell = 0;
	while (cell < grid->GetNumberOfCells() && keptOf(cell) == cells->GetCellSize(cell))
		++cell;
	if (cell == grid->GetNumberOfCells() || grid->GetFaces())
		return;
	vtkNew<vtkCellArray> trimmed;
	vtkNew<vtkIdList> ids;
	for (cell = 0; cell < grid->GetNumberOfCells(); ++cell)
	{
		cells->GetCellAtId(cell, ids);
		trimmed->InsertNextCell(keptOf(cell), ids->GetPointer(0));
	}
	grid->SetCells(types, trimmed);
}

} // namespace

bool keepsCurved(vtkUnstructuredGrid* grid, double tolerance)
{
	if (!grid->GetPoints() || !grid->GetCells() || !grid->GetCellTypesArray())
		return false;
	refuseBadLists(grid);
	const vtkIdType count = grid->GetNumberOfCells();
	bool any = false;
	for (vtkIdType c = 0; c < count && !any; ++c)
		any = isCurved(grid->GetCellTypesArray()->GetValue(c));
	if (!any)
		return false;
	trimLists(grid);
	findShapeArrays(grid);
	uncollapse(grid, true);
	const vtkUnsignedCharArray* types = grid->GetCellTypesArray();
	vtkUnsignedCharArray* ghosts = ghostMarks(grid);
	SourceCells source(grid);
	CellsInOrder order(grid, source);
	vtkNew<vtkIdList> ids;
	for (vtkIdType c = 0; c < count; ++c)
	{
		const std::uint8_t type = types->GetValue(c);
		if (read::cellDimension(type) < 3 || (ghosts && (ghosts->GetValue(c) & kHiddenCellBits)))
			continue;
		const vtkIdType points = grid->GetCells()->GetCellSize(c);
		if (read::slicedCellSize(type) > 0 || grid::isCurved(type))
		{
			grid->GetCells()->GetCellAtId(c, ids);
			if (hasEqualCorners(type, ids))
				throw Refusal(fmt::format("--refine {}: cell {} is a {} with fewer corners than its type has, which a "
				                          "tolerance does not refine; give a level, such as --refine 1",
				                          tolerance, c, shortName(type)));
		}
		if (read::slicedCellSize(type) > 0)
			continue;
		if (!grid::isCurved(type))
			throw Refusal(fmt::format("--refine {}: cell {} is a {} of {} points, which a tolerance does not refine; "
			                          "give a level, such as --refine 1",
			                          tolerance, c, shortName(type), points));
		if (const int fixed = grid::fixedNodes(type); fixed > 0 && points != fixed)
			throw damaged(fmt::format("cell {} of type {} lists {} points", c, type, points));
		if (!grid::hasDegrees(type))
			continue;
		checkPoints(grid, c, ids);
		order.add(c, type, source.enter(c, type, ids), ids);
	}
	order.apply();
	return true;
}

void writeShapeArrays(arrays::Writer& writer, vtkUnstructuredGrid* grid, nlohmann::json& cells)
{
	vtkDataArray* degrees = grid->GetCellData()->GetHigherOrderDegrees();
	if (degrees && degrees->GetNumberOfComponents() == 3 && degrees->GetNumberOfTuples() == grid->GetNumberOfCells())
	{
		std::vector<std::int32_t> numbers;
		for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
			for (int axis = 0; axis < 3; ++axis)
			{
				const double degree = degrees->GetComponent(c, axis);
				numbers.push_back(degree >= 1.0 && degree <= grid::kMaxDegree ? static_cast<std::int32_t>(degree) : 0);
			}
		cells["degrees"] = writer.write(grid::NumberType::int32, numbers.data(), 4 * numbers.size());
	}
	vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
	if (weights && weights->GetNumberOfComponents() == 1 && weights->GetNumberOfTuples() == grid->GetNumberOfPoints())
	{
		std::vector<double> numbers;
		for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
			numbers.push_back(weights->GetComponent(p, 0));
		cells["weights"] = writer.write(grid::NumberType::float64, numbers.data(), 8 * numbers.size());
	}
}

} // namespace vp::reader::cells
