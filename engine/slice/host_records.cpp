#include "slice/host_records.h"

#include "slice/polygon_fans.h"

#include <cmath>
#include <numeric>

namespace vp::slice
{

namespace
{

// Infinite data would overrun the marks for NaN and for an empty pixel.
constexpr double kLargestValue = 2.0e38;

// The records of one polygon after the other.
class RecordMaker
{
public:
	// `values` of the corners.
	void add(CellId cell, std::span<const glm::dvec2> places, std::span<const float> values)
	{
		if (!isFan(places))
		{
			for (const std::vector<std::uint32_t>& fan : cutIntoFans(places))
				addFan(cell, fan, places, values);
			return;
		}
		whole_.resize(places.size());
		std::iota(whole_.begin(), whole_.end(), 0u);
		addFan(cell, whole_, places, values);
	}

	std::vector<shared::PolygonRecord> records;

private:
	void addFan(CellId cell, std::span<const std::uint32_t> fan, std::span<const glm::dvec2> places,
	            std::span<const float> values)
	{
		const auto corner = [&](shared::PolygonRecord& record, std::uint32_t v)
		{
			record.uv[2 * record.vertices] = static_cast<float>(places[v].x);
			record.uv[2 * record.vertices + 1] = static_cast<float>(places[v].y);
			record.value[record.vertices] = values[v];
			++record.vertices;
		};
		for (std::size_t next = 1; next + 1 < fan.size();)
		{
			shared::PolygonRecord record{};
			record.cell = cell;
			corner(record, fan[0]);
			corner(record, fan[next]);
			while (record.vertices < shared::kMaxRecordVertices && next + 1 < fan.size())
				corner(record, fan[++next]);
			records.push_back(record);
		}
	}

	std::vector<std::uint32_t> whole_;
};

// valueOf(polygon, vertex), at its corners.
template <class Values>
std::vector<shared::PolygonRecord> makeRecords(const probe::Sheet& sheet, const SheetMesh& mesh, const Values& valueOf)
{
	const Vec3 x_axis = sheet.xAxis();
	RecordMaker maker;
	maker.records.reserve(mesh.polygons());
	std::vector<glm::dvec2> places;
	std::vector<float> values;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		places.clear();
		values.clear();
		for (const std::uint32_t v : mesh.polygon(p))
		{
			const Vec3 from_origin = mesh.positions[v] - sheet.origin;
			places.emplace_back(glm::dot(from_origin, x_axis), glm::dot(from_origin, sheet.up));
			values.push_back(valueOf(p, v));
		}
		maker.add(mesh.polygon_cells[p].cell, places, values);
	}
	return std::move(maker.records);
}

} // namespace

float drawnValue(double value)
{
	return std::isnan(value) ? shared::kNanValue : static_cast<float>(std::clamp(value, -kLargestValue, kLargestValue));
}

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

	return makeRecords(sheet, mesh,
	                   [&](std::size_t p, std::uint32_t v)
	                   {
		                   if (on_points)
			                   return vertex_values[v];
		                   const auto [b, cell] = mesh.polygon_cells[p];
		                   const grid::Field* of_block = field ? field->in(blocks.blocks[b]) : nullptr;
		                   return of_block ? drawnValue(cellValue(blocks.blocks[b], *of_block, field->component, cell))
		                                   : no_array;
	                   });
}

std::vector<shared::PolygonRecord> recordsFromMesh(const probe::Sheet& sheet, const SheetMesh& mesh,
                                                   std::span<const double> polygon_values)
{
	return makeRecords(sheet, mesh, [&](std::size_t p, std::uint32_t) { return drawnValue(polygon_values[p]); });
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
