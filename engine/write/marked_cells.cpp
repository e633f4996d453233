#include "write/marked_cells.h"

#include "write/atomic_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

namespace vp::write
{

Status writeMarkedCells(const grid::BlockSet& blocks, std::span<const MarkedCells> marked, const std::string& path)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();

	vtkNew<vtkPoints> points;
	points->SetDataTypeToDouble();
	vtkNew<vtkCellArray> polygons;
	vtkNew<vtkStringArray> finding;
	finding->SetName("vprobe:finding");
	vtkNew<vtkTypeInt64Array> source;
	source->SetName("vprobe:cell");
	vtkNew<vtkTypeInt32Array> block;
	block->SetName("vprobe:block");
	grid::CellFaces faces;
	for (const MarkedCells& group : marked)
		for (const grid::SetCell& cell : group.cells)
			std::visit(
			    [&](const auto& grid)
			    {
				    grid.cellFaces(cell.cell, faces);
				    for (int f = 0; f < faces.size(); ++f)
				    {
					    polygons->InsertNextCell(static_cast<int>(faces[f].size()));
					    for (const PointId p : faces[f])
					    {
						    const Vec3 x = grid.point(p);
						    polygons->InsertCellPoint(points->InsertNextPoint(x.x, x.y, x.z));
					    }
					    finding->InsertNextValue(group.mark);
					    source->InsertNextValue(static_cast<std::int64_t>(grid.sourceCell(cell.cell)));
					    block->InsertNextValue(static_cast<std::int32_t>(cell.block));
				    }
			    },
			    blocks.blocks[cell.block].grid);

	vtkNew<vtkPolyData> shown;
	shown->SetPoints(points);
	shown->SetPolys(polygons);
	shown->GetCellData()->AddArray(finding);
	shown->GetCellData()->AddArray(source);
	shown->GetCellData()->AddArray(block);
	// To memory first, as in writeVtp().
	vtkNew<vtkXMLPolyDataWriter> writer;
	writer->SetInputData(shown);
	writer->SetDataModeToAppended();
	writer->EncodeAppendedDataOff();
	writer->SetHeaderTypeToUInt64();
	writer->SetCompressorTypeToNone();
	writer->WriteToOutputStringOn();
	writer->Write();
	file->write(writer->GetOutputString());
	return file->commit();
}

} // namespace vp::write
