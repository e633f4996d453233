#include "measure/stats.h"

#include "base/ordered_sum.h"
#include "base/parallel_reduce.h"
#include "measure/components.h"
#include "mesh/fetch_values.h"
#include "mesh/mesh_values.h"
#include "mesh/nearest_parts.h"
#include "mesh/own_polygons.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace vp::measure
{

namespace
{

// The figures of one polygon. They are added up as they come, which is the same wherever the polygon is measured.
struct PolygonSums
{
	double area = 0.0;
	double nan_area = 0.0;
	double value_area = 0.0;

	// A polygon with a value of its own, or, where vertex_values are given, as the fan about the mean of its vertices.
	void addPolygon(const mesh::SheetMesh& mesh, std::span<const std::uint32_t> polygon,
	                std::span<const double> vertex_values, double polygon_value)
	{
		if (vertex_values.empty() && mesh.flat)
			return addPart(0.5 * glm::length(mesh::doubleArea(mesh, polygon)), polygon_value);
		double center_value = 0.0;
		if (!vertex_values.empty())
			for (const std::uint32_t v : polygon)
				center_value += vertex_values[v];
		center_value /= static_cast<double>(polygon.size());
		mesh::forFan(mesh, polygon,
		             [&](std::uint32_t v, std::uint32_t w, double part)
		             {
			             const double value = vertex_values.empty()
			                                      ? polygon_value
			                                      : (vertex_values[v] + vertex_values[w] + center_value) / 3.0;
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
	void addTo(AreaSums& sums) const
	{
		sums.area += area;
		if (nan_area != 0.0)
			sums.nan_area += nan_area;
		if (value_area != 0.0)
			sums.value_area += value_area;
	}
};

void addValue(SheetSums& sums, double value)
{
	if (!std::isfinite(value))
		return;
	sums.min = std::min(sums.min, value);
	sums.max = std::max(sums.max, value);
}

// Values of vertices, with the range at the polygons' own corners.
SheetSums takeVertexValues(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const mesh::OwnPolygons& own,
                           const grid::FieldChoice& field, std::vector<double>& values)
{
	values.resize(mesh.positions.size());
	const std::vector<const grid::Field*> fields = field.inEach(blocks);
	return orderedSum<SheetSums>(values.size(),
	                             [&](SheetSums& sums, std::size_t v)
	                             {
		                             values[v] = mesh::vertexValue(blocks, mesh, v, fields, field.component);
		                             if (own.isCorner(v))
			                             addValue(sums, values[v]);
	                             });
}

// Sums up values of points that are shown by the nearest one: labels, which have no mean between two of them.
SheetSums sumUpNearest(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const grid::FieldChoice& field)
{
	const mesh::NearestParts parts = mesh::nearestParts(blocks, mesh, field.inEach(blocks), field.component);
	const std::size_t of_cells = parts.mesh.polygons() - parts.mesh.boundary_polygons;
	return orderedSum<SheetSums>(parts.mesh.polygons(),
	                             [&](SheetSums& sums, std::size_t p)
	                             {
		                             addValue(sums, parts.values[p]);
		                             PolygonSums of_polygon;
		                             of_polygon.addPolygon(parts.mesh, parts.mesh.polygon(p), {}, parts.values[p]);
		                             of_polygon.addTo(p < of_cells ? sums.cut : sums.boundary);
	                             });
}

// Returns true if is_finite(i) holds for each i < count. It is called on all cores.
template <class IsFinite>
bool areFinite(std::size_t count, const IsFinite& is_finite)
{
	const auto all = [&](const tbb::blocked_range<std::size_t>& part, bool so_far)
	{
		for (std::size_t i = part.begin(); so_far && i < part.end(); ++i)
			so_far = is_finite(i);
		return so_far;
	};
	return parallelReduce(count, 4096, true, all, std::logical_and<>());
}

// Returns true if all values that `count` lookups could return are known to be finite.
bool areKnownFinite(std::span<const grid::Field* const> fields, int component, std::size_t count, FiniteFields& known)
{
	const std::size_t share = count / fields.size() + 1;
	return std::ranges::all_of(fields, [&](const grid::Field* field)
	                           { return field && component < field->components && known.holds(*field, share); });
}

} // namespace

double nanArea(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, const std::optional<grid::FieldChoice>& field,
               FiniteFields* known)
{
	if (!field || blocks.blocks.empty())
		return 0.0;
	const std::vector<const grid::Field*> fields = field->inEach(blocks);
	const bool on_points = field->association == grid::Association::point;
	const std::size_t count = on_points ? mesh.positions.size() : mesh.polygons();
	if (known && areKnownFinite(fields, field->component, count, *known))
		return 0.0;
	mesh::fetchValues(blocks, mesh, fields);
	const auto ofVertex = [&](std::size_t v)
	{ return std::isfinite(mesh::vertexValue(blocks, mesh, v, fields, field->component)); };
	const auto ofPolygon = [&](std::size_t p)
	{
		const auto [b, cell] = mesh.polygon_cells[p];
		return fields[b] && std::isfinite(mesh::cellValue(blocks.blocks[b], *fields[b], field->component, cell));
	};
	const bool finite = on_points ? areFinite(count, ofVertex) : areFinite(count, ofPolygon);
	return finite ? 0.0 : measure(blocks, mesh, field).nan_area;
}

void AreaSums::add(const AreaSums& other)
{
	area += other.area;
	nan_area += other.nan_area;
	value_area += other.value_area;
}

std::optional<double> AreaSums::mean() const
{
	const double valued = area.value() - nan_area.value();
	return valued > 0.0 ? std::optional(value_area.value() / valued) : std::nullopt;
}

void SheetSums::add(const SheetSums& other)
{
	cut.add(other.cut);
	boundary.add(other.boundary);
	min = std::min(min, other.min);
	max = std::max(max, other.max);
}

SheetSums sumUp(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                const std::optional<grid::FieldChoice>& field)
{
	const bool on_points = field && field->association == grid::Association::point;
	if (on_points && grid::isCategorical(blocks, field))
		return sumUpNearest(blocks, mesh, *field);
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	std::vector<double> vertex_values;
	const mesh::OwnPolygons own(mesh);
	const auto fields = field ? field->inEach(blocks) : std::vector<const grid::Field*>(blocks.blocks.size());
	mesh::fetchValues(blocks, mesh, fields);
	const SheetSums of_vertices = on_points ? takeVertexValues(blocks, mesh, own, *field, vertex_values) : SheetSums();
	const std::size_t of_cells = mesh.polygons() - mesh.boundary_polygons;
	SheetSums sums = orderedSum<SheetSums>(mesh.polygons(),
	                                       [&](SheetSums& part, std::size_t p)
	                                       {
		                                       const auto polygon = own[p];
		                                       const auto [b, cell] = mesh.polygon_cells[p];
		                                       double polygon_value = kNan;
		                                       if (field && !on_points)
		                                       {
			                                       if (fields[b])
				                                       polygon_value = mesh::cellValue(blocks.blocks[b], *fields[b],
				                                                                       field->component, cell);
			                                       addValue(part, polygon_value);
		                                       }
		                                       PolygonSums of_polygon;
		                                       of_polygon.addPolygon(mesh, polygon, vertex_values, polygon_value);
		                                       of_polygon.addTo(p < of_cells ? part.cut : part.boundary);
	                                       });
	sums.add(of_vertices);
	return sums;
}

SheetMeasure measureOf(const SheetSums& sums, bool has_field)
{
	SheetMeasure result;
	result.area = sums.cut.area.value();
	result.boundary_area = sums.boundary.area.value();
	if (!has_field)
		return result;
	result.nan_area = sums.cut.nan_area.value();
	result.mean = sums.cut.mean();
	result.boundary_mean = sums.boundary.mean();
	if (sums.min <= sums.max)
	{
		result.min = sums.min;
		result.max = sums.max;
	}
	return result;
}

SheetMeasure measure(const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                     const std::optional<grid::FieldChoice>& field)
{
	SheetMeasure result = measureOf(sumUp(blocks, mesh, field), field.has_value());
	result.components = countComponents(mesh);
	return result;
}

} // namespace vp::measure
