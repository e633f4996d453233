#include "linearize.h"

#include "cell_lists.h"
#include "cells_in_order.h"
#include "collapsed_cells.h"
#include "grown_cells.h"
#include "linear_parts.h"
#include "new_nodes.h"
#include "read/cell_types.h"
#include "read/prisms.h"
#include "source_cell.h"
#include "visible_cells.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOrderedTriangulator.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::cells
{

namespace
{

// A cell takes about 200 bytes, half of them for the grid that is built from it.
constexpr double kMaxRefinedCells = 1e8;

bool isRewritten(std::uint8_t type)
{
	return isCurved(type) || read::prismSides(type) > 0 || type == VTK_CONVEX_POINT_SET;
}

class Linearizer
{
public:
	Linearizer(vtkUnstructuredGrid* grid, int level)
	    : grid_(grid), level_(level), nodes_(grid), source_(grid), ghosts_(ghostMarks(grid))
	{
	}

	LinearCells run()
	{
		lookAtCells();
		for (vtkIdType c = 0; c < grid_->GetNumberOfCells(); ++c)
		{
			const std::uint8_t type = loadCell(c);
			cell_ = c;
			cells_.startSource(c);
			if (isShown(c) && isCurved(type))
				addCurved(type);
			else if (isShown(c) && read::prismSides(type) > 0)
				addPrism(read::prismSides(type));
			else if (isShown(c) && type == VTK_CONVEX_POINT_SET)
				addPointSet();
			else
				addUnchanged(type);
		}
		return finish();
	}

private:
	std::uint8_t loadCell(vtkIdType cell)
	{
		const auto type = static_cast<std::uint8_t>(grid_->GetCellType(cell));
		grid_->GetCells()->GetCellAtId(cell, ids_);
		if (isRewritten(type))
			for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i)
				if (ids_->GetId(i) < 0 || ids_->GetId(i) >= grid_->GetNumberOfPoints())
					throw damaged(
					    fmt::format("cell {} lists point {} of {}", cell, ids_->GetId(i), grid_->GetNumberOfPoints()));
		return type;
	}

	bool isShown(vtkIdType cell) const { return !ghosts_ || (ghosts_->GetValue(cell) & kHiddenCellBits) == 0; }

	// Counts the parts before any is made, and brings the nodes into VTK's order.
	void lookAtCells()
	{
		double cells = 0.0;
		CellsInOrder order(grid_, source_);
		for (vtkIdType c = 0; c < grid_->GetNumberOfCells(); ++c)
		{
			const std::uint8_t type = loadCell(c);
			if (!isShown(c) || !isCurved(type))
				continue;
			CellKind& kind = source_.enter(c, type, ids_);
			cells += countParts(kind.split, level_);
			order.add(c, type, kind, ids_);
		}
		if (level_ > 0 && cells > kMaxRefinedCells)
			throw Refusal(
			    fmt::format("--refine {} makes {:.0f} linear cells of it, more than {:.0f}; give a lower level", level_,
			                cells, kMaxRefinedCells));
		order.apply();
	}

	void addCurved(std::uint8_t type)
	{
		const CellKind& kind = source_.enter(cell_, type, ids_);
		nodes_.enterCell(ids_);
		corners_.clear();
		for (vtkIdType p = 0; p < ids_->GetNumberOfIds(); ++p)
			corners_.push_back({ids_->GetId(p), kind.at[static_cast<std::size_t>(p)]});
		if (kind.handles)
			placeHandles();
		for (const LinearCell& part : cutter_.parts(kind.split, corners_, level_))
		{
			for (int i = 0; i < pointsOf(part.type); ++i)
				cells_.addPoint(part.corners[static_cast<std::size_t>(i)].point);
			cells_.endCell(part.type);
		}
	}

	void placeHandles()
	{
		placed_.resize(nodes_.count());
		for (const Corner& corner : corners_)
			if (!placed_[static_cast<std::size_t>(corner.point)])
			{
				nodes_.place(corner.point, source_.weights(corner.at));
				placed_[static_cast<std::size_t>(corner.point)] = true;
			}
	}

	void addPrism(int sides)
	{
		if (ids_->GetNumberOfIds() < 2 * sides)
			throw damaged(
			    fmt::format("cell {}, a prism of {} sides, lists {} points", cell_, sides, ids_->GetNumberOfIds()));
		cells_.addPrism({ids_->GetPointer(0), static_cast<std::size_t>(2 * sides)});
	}

	// Points are sorted by their ids, so that a flat face of more than three points is cut alike from either side.
	void addPointSet()
	{
		const vtkIdType count = ids_->GetNumberOfIds();
		vtkNew<vtkIdList> tetrahedra;
		vtkNew<vtkPoints> ignored;
		Box box;
		for (vtkIdType i = 0; i < count; ++i)
		{
			const Vec3 at = nodes_.at(ids_->GetId(i));
			if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
				return addUnplaced(ids_->GetId(i));
			box.include(at);
		}
		if (count >= 4)
		{
			triangulator_->InitTriangulation(box.lo.x, box.hi.x, box.lo.y, box.hi.y, box.lo.z, box.hi.z,
			                                 static_cast<int>(count));
			for (vtkIdType i = 0; i < count; ++i)
			{
				Vec3 at = nodes_.at(ids_->GetId(i));
				triangulator_->InsertPoint(i, ids_->GetId(i), &at.x, &at.x, 0);
			}
			triangulator_->Triangulate();
			triangulator_->AddTetras(0, tetrahedra, ignored);
		}
		if (tetrahedra->GetNumberOfIds() == 0)
			return cells_.endCell(read::kEmptyCell);
		for (vtkIdType i = 0; i < tetrahedra->GetNumberOfIds(); ++i)
		{
			cells_.addPoint(ids_->GetId(tetrahedra->GetId(i)));
			if (i % 4 == 3)
				cells_.endCell(read::kTetra);
		}
	}

	// The program leaves out cells with a point whose coordinates are not finite, and counts them.
	void addUnplaced(vtkIdType point)
	{
		for (int corner = 0; corner < 4; ++corner)
			cells_.addPoint(point);
		cells_.endCell(read::kTetra);
	}

	void addUnchanged(std::uint8_t type)
	{
		for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i)
			cells_.addPoint(ids_->GetId(i));
		if (type == read::kPolyhedron)
			cells_.addFaces(polyhedronFaces(grid_, cell_));
		cells_.endCell(type);
	}

	LinearCells finish()
	{
		LinearCells made{vtkSmartPointer<vtkUnstructuredGrid>::New(), cells_.takeSources()};
		made.grid->SetPoints(nodes_.points());
		for (int a = 0; a < nodes_.data()->GetNumberOfArrays(); ++a)
			made.grid->GetPointData()->AddArray(nodes_.data()->GetArray(a));
		cells_.fill(made.grid);
		if (ghosts_)
		{
			vtkNew<vtkUnsignedCharArray> marks;
			marks->SetName(vtkDataSetAttributes::GhostArrayName());
			for (const std::int64_t cell : made.source_cells)
				marks->InsertNextValue(ghosts_->GetValue(cell));
			made.grid->GetCellData()->AddArray(marks);
		}
		return made;
	}

	vtkUnstructuredGrid* grid_;
	int level_;
	NewNodes nodes_;
	GrownCells cells_;
	SourceCells source_;
	PartCutter cutter_{nodes_, source_};
	vtkUnsignedCharArray* ghosts_;
	vtkNew<vtkOrderedTriangulator> triangulator_;

	vtkIdType cell_ = 0; // being rewritten
	vtkNew<vtkIdList> ids_;
	std::vector<Corner> corners_;
	std::vector<bool> placed_;
};

} // namespace

std::optional<LinearCells> linearize(vtkUnstructuredGrid* grid, int level)
{
	if (!grid->GetPoints() || !grid->GetCells() || !grid->GetCellTypesArray())
		return std::nullopt;
	refuseBadLists(grid);
	const vtkUnsignedCharArray* types = grid->GetCellTypesArray();
	bool any = false;
	for (vtkIdType c = 0; c < grid->GetNumberOfCells() && !any; ++c)
		any = isRewritten(types->GetValue(c));
	if (!any)
		return std::nullopt;
	findShapeArrays(grid);
	uncollapse(grid, false);
	return Linearizer(grid, level).run();
}

} // namespace vp::reader::cells
