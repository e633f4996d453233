#include "write/slice_formats.h"

namespace vp::write
{

PolyData polyDataOf(const SliceTable& table)
{
	using grid::NumberType;

	PolyData data;
	data.points = table.positions;
	data.polygons = {table.polygon_starts, table.polygon_vertices};
	data.point_arrays.add(table.vertex_columns);
	data.cell_arrays.add(table.polygon_columns);
	data.cell_arrays.add(xmlArray("vprobe:cell", NumberType::int64, 1, table.cell));
	data.cell_arrays.add(xmlArray("vprobe:block", NumberType::int32, 1, table.block));
	data.cell_arrays.add(xmlArray("vprobe:sheet", NumberType::int32, 1, table.sheet));
	if (table.has_contours)
		data.cell_arrays.add(xmlArray("vprobe:contour", NumberType::float64, 1, table.contour));
	return data;
}

void writeVtp(const SliceTable& table, AtomicFile& file)
{
	writePolyData(polyDataOf(table), file);
}

} // namespace vp::write
