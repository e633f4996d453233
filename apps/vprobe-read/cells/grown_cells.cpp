#include "grown_cells.h"

#include "read/cell_types.h"
#include "read/prisms.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

namespace vp::reader::cells
{

GrownCells::GrownCells()
{
	offsets_->InsertNextValue(0);
}

GrownCells::~GrownCells() = default;

void GrownCells::addPoint(vtkIdType point)
{
	connectivity_->InsertNextValue(point);
}

void GrownCells::addFaces(std::span<const vtkIdType> stream)
{
	face_location_ = faces_->GetNumberOfValues();
	for (const vtkIdType value : stream)
		faces_->InsertNextValue(value);
}

void GrownCells::endCell(std::uint8_t type)
{
	types_->InsertNextValue(type);
	offsets_->InsertNextValue(connectivity_->GetNumberOfValues());
	face_locations_->InsertNextValue(face_location_);
	sources_.push_back(source_);
	face_location_ = -1;
}

void GrownCells::addPrism(std::span<const vtkIdType> points)
{
	for (const vtkIdType point : points)
		addPoint(point);
	addFaces(read::prismFaces(points));
	endCell(read::kPolyhedron);
}

void GrownCells::fill(vtkUnstructuredGrid* grid) const
{
	vtkNew<vtkCellArray> cells;
	cells->SetData(offsets_, connectivity_);
	if (faces_->GetNumberOfValues() > 0)
		grid->SetCells(types_, cells, face_locations_, faces_);
	else
		grid->SetCells(types_, cells);
}

} // namespace vp::reader::cells
