#include "slice/stats.h"

#include "slice/components.h"

#include <cmath>
#include <limits>

namespace vp::slice
{

namespace
{

struct Sums
{
	double area = 0.0;
	double boundary_area = 0.0;
	double nan_area = 0.0;
	double value_area = 0.0; // integral of the values over the area that is not NaN
	double min = std::numeric_limits<double>::infinity();
	double max = -std::numeric_limits<double>::infinity();

	// A polygon with a value of its own, or, where vertex_values are given, as the fan about the mean of its vertices.
	void addPolygon(const SheetMesh& mesh, std::span<const std::uint32_t> polygon,
	                std::span<const double> vertex_values, double polygon_value)
	{
		if (vertex_values.empty() && mesh.flat)
			return addPart(0.5 * glm::length(doubleArea(mesh, polygon)), polygon_value);
		double centre_value = 0.0;
		if (!vertex_values.empty())
			for (const std::uint32_t v : polygon)
				centre_value += vertex_values[v];
		centre_value /= static_cast<double>(polygon.size());
		forFan(mesh, polygon,
		       [&](std::uint32_t v, std::uint32_t w, double part)
		       {
			       const double value = vertex_values.empty()
			                                ? polygon_value
			                                : (vertex_values[v] + vertex_values[w] + centre_value) / 3.0;
			       addPart(part, value);
		       });
	}
	void addPart(double area_part, double mean_value)
	{
		area += area_part;
		if (!std::isfinite(mean_value))
			nan_area += area_part;
		else
			value_area += area_part * mean_value;
	}
	void addValue(double value)
	{
		if (!std::isfinite(value))
			return;
		min = std::min(min, value);
		max = std::max(max, value);
	}
};

} // namespace

SheetMeasure measure(const grid::BlockSet& blocks, const SheetMesh& mesh, const std::optional<FieldChoice>& field)
{
	const bool on_points = field && field->association == grid::Association::point;
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	Sums sums;
	std::vector<double> vertex_values;
	if (on_points)
	{
		vertex_values.reserve(mesh.positions.size());
		const std::vector<const grid::Field*> fields = field->inEach(blocks);
		for (std::size_t v = 0; v < mesh.positions.size(); ++v)
		{
			vertex_values.push_back(vertexValue(blocks, mesh, v, fields, field->component));
			sums.addValue(vertex_values.back());
		}
	}
	const std::size_t of_cells = mesh.polygons() - mesh.boundary_polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		double polygon_value = kNan;
		if (field && !on_points)
		{
			const grid::Block& block = blocks.blocks[mesh.polygon_cells[p].block];
			if (const grid::Field* values = field->in(block))
				polygon_value = cellValue(block, *values, field->component, mesh.polygon_cells[p].cell);
			sums.addValue(polygon_value);
		}
		if (p < of_cells)
			sums.addPolygon(mesh, polygon,
			                on_points ? std::span<const double>(vertex_values) : std::span<const double>(),
			                polygon_value);
		else
			sums.boundary_area += 0.5 * glm::length(doubleArea(mesh, polygon));
	}

	SheetMeasure result;
	result.area = sums.area;
	result.boundary_area = sums.boundary_area;
	result.components = countComponents(mesh);
	if (!field)
		return result;
	result.nan_area = sums.nan_area;
	if (const double valued = sums.area - sums.nan_area; valued > 0.0)
		result.mean = sums.value_area / valued;
	if (sums.min <= sums.max)
	{
		result.min = sums.min;
		result.max = sums.max;
	}
	return result;
}

} // namespace vp::slice
