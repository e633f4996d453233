#include "write/marked_cells.h"

#include "write/atomic_file.h"
#include "write/poly_data.h"

namespace vp::write
{

Status writeMarkedCells(const grid::BlockSet& blocks, std::span<const MarkedCells> marked, const std::string& path)
{
	using grid::NumberType;

	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();

	std::vector<Vec3> points;
	std::vector<std::int64_t> starts{0};
	std::vector<std::int64_t> ids;
	std::string finding;
	std::vector<std::int64_t> source;
	std::vector<std::int32_t> block;
	grid::CellFaces faces;
	for (const MarkedCells& group : marked)
		for (const grid::SetCell& cell : group.cells)
			std::visit(
			    [&](const auto& grid)
			    {
				    grid.cellFaces(cell.cell, faces);
				    for (int f = 0; f < faces.size(); ++f)
				    {
					    for (const PointId p : faces[f])
					    {
						    ids.push_back(static_cast<std::int64_t>(points.size()));
						    points.push_back(grid.point(p));
					    }
					    starts.push_back(static_cast<std::int64_t>(ids.size()));
					    (finding += group.mark) += '\0';
					    source.push_back(grid::cellNumber(blocks.blocks[cell.block], cell.cell));
					    block.push_back(static_cast<std::int32_t>(cell.block));
				    }
			    },
			    blocks.blocks[cell.block].grid);

	PolyData data;
	data.points = points;
	data.polygons = {starts, ids};
	data.cell_arrays.add(xmlTexts("vprobe:finding", finding));
	data.cell_arrays.add(xmlArray("vprobe:cell", NumberType::int64, 1, source));
	data.cell_arrays.add(xmlArray("vprobe:block", NumberType::int32, 1, block));
	writePolyData(data, *file);
	return file->commit();
}

} // namespace vp::write
