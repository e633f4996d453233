#pragma once

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <utility>
#include <vector>

namespace vp::reader::vtk
{

// Reads files below version 2.1, whose hexahedra of higher degree have another order of nodes. VTK brings the cells of
// all pieces read so far into its own order after each piece, and so those of the first ones back again. Here each cell
// is as VTK leaves it after its own piece.
class OldPiecesReader : public vtkXMLUnstructuredGridReader
{
public:
	static OldPiecesReader* New() { VTK_STANDARD_NEW_BODY(OldPiecesReader); }
	vtkTemplateTypeMacro(OldPiecesReader, vtkXMLUnstructuredGridReader);

protected:
	int ReadPieceData() override
	{
		const int result = vtkXMLUnstructuredGridReader::ReadPieceData();
		auto* grid = vtkUnstructuredGrid::SafeDownCast(GetCurrentOutput());
		const bool is_old = GetFileMajorVersion() < 2 || (GetFileMajorVersion() == 2 && GetFileMinorVersion() < 1);
		if (!grid || !grid->GetCells() || !is_old || NumberOfPieces < 2)
			return result;
		vtkCellArray* cells = grid->GetCells();
		if (cells->GetNumberOfCells() < seen_) // another time step
		{
			seen_ = 0;
			right_.clear();
		}
		vtkNew<vtkIdList> ids;
		for (const auto& [cell, nodes] : right_)
			cells->ReplaceCellAtId(cell, static_cast<vtkIdType>(nodes.size()), nodes.data());
		for (; seen_ < cells->GetNumberOfCells(); ++seen_)
			if (const int type = grid->GetCellType(seen_);
			    type == VTK_LAGRANGE_HEXAHEDRON || type == VTK_BEZIER_HEXAHEDRON)
			{
				cells->GetCellAtId(seen_, ids);
				right_.emplace_back(seen_, std::vector<vtkIdType>(ids->begin(), ids->end()));
			}
		return result;
	}

private:
	vtkIdType seen_ = 0; // cells of the pieces before
	std::vector<std::pair<vtkIdType, std::vector<vtkIdType>>> right_;
};

} // namespace vp::reader::vtk
