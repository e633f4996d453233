#include "slice/host_records.h"

#include <cmath>

namespace vp::slice
{

namespace
{

// Infinite data would overrun the marks for NaN and for an empty pixel.
constexpr double kLargestValue = 2.0e38;

float drawnValue(double value)
{
	return std::isnan(value) ? shared::kNanValue : static_cast<float>(std::clamp(value, -kLargestValue, kLargestValue));
}

} // namespace

std::vector<shared::PolygonRecord> recordsFromMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet,
                                                   const SheetMesh& mesh, const std::optional<FieldChoice>& field)
{
	const bool on_points = field && field->association == grid::Association::point;
	const float no_array = field ? shared::kNanValue : 0.0f;
	std::vector<float> vertex_values;
	if (on_points)
	{
		vertex_values.reserve(mesh.positions.size());
		const std::vector<const grid::Field*> fields = field->inEach(blocks);
		for (std::size_t v = 0; v < mesh.positions.size(); ++v)
			vertex_values.push_back(drawnValue(vertexValue(blocks, mesh, v, fields, field->component)));
	}

	const Vec3 x_axis = sheet.xAxis();
	std::vector<shared::PolygonRecord> records;
	records.reserve(mesh.polygons());
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto [b, cell] = mesh.polygon_cells[p];
		float polygon_value = no_array;
		if (field && !on_points)
			if (const grid::Field* values = field->in(blocks.blocks[b]))
				polygon_value = drawnValue(cellValue(blocks.blocks[b], *values, field->component, cell));

		const auto polygon = mesh.polygon(p);
		const auto corner = [&](shared::PolygonRecord& record, std::uint32_t v)
		{
			const Vec3 from_origin = mesh.positions[v] - sheet.origin;
			record.uv[2 * record.vertices] = static_cast<float>(glm::dot(from_origin, x_axis));
			record.uv[2 * record.vertices + 1] = static_cast<float>(glm::dot(from_origin, sheet.up));
			record.value[record.vertices] = on_points ? vertex_values[v] : polygon_value;
			++record.vertices;
		};
		for (std::size_t next = 1; next + 1 < polygon.size();)
		{
			shared::PolygonRecord record{};
			record.cell = cell;
			corner(record, polygon[0]);
			corner(record, polygon[next]);
			while (record.vertices < shared::kMaxRecordVertices && next + 1 < polygon.size())
				corner(record, polygon[++next]);
			records.push_back(record);
		}
	}
	return records;
}

traverse::LaneCut walkedCells(const traverse::LaneCut& cut)
{
	traverse::LaneCut walked;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kWordWalk && cut.words[i] & shared::kWordCut)
		{
			walked.cells.push_back(cut.cells[i]);
			walked.words.push_back(cut.words[i]);
		}
	walked.cut_cells = walked.cells.size();
	return walked;
}

} // namespace vp::slice
