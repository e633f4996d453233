#include "render/scene/sheet_contours.h"

#include "measure/cell_steps.h"
#include "measure/contour_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::render
{

Interpolated interpolated(std::span<const std::uint32_t> polygon, std::span<const double> of_vertices)
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	const auto all = [&](const auto& is)
	{ return std::ranges::all_of(polygon, [&](std::uint32_t v) { return is(of_vertices[v]); }); };
	if (all([](double value) { return std::isfinite(value); }))
		return Interpolated::values;
	if (all([](double value) { return value == kInfinity; }))
		return Interpolated::plus_infinity;
	return all([](double value) { return value == -kInfinity; }) ? Interpolated::minus_infinity : Interpolated::nothing;
}

std::vector<double> finiteOnly(std::span<const double> values)
{
	std::vector<double> finite(values.begin(), values.end());
	std::ranges::replace_if(
	    finite, [](double value) { return std::isinf(value); }, std::numeric_limits<double>::quiet_NaN());
	return finite;
}

std::vector<LevelLine> levelLines(const mesh::SheetMesh& mesh, const probe::Frame& frame, const SheetValues& values,
                                  std::span<const double> levels)
{
	std::vector<LevelLine> lines;
	const auto take = [&](std::vector<measure::PlaneLine> found, double level)
	{
		for (measure::PlaneLine& line : found)
			lines.push_back({level, std::move(line)});
	};
	if (!values.of_polygons.empty())
	{
		const std::vector<glm::dvec2> points = measure::planePoints(mesh, frame);
		for (const double level : levels)
			take(measure::stepLines(mesh, points, values.of_polygons, level), level);
	}
	else if (!values.of_vertices.empty())
	{
		const measure::PlaneTriangles triangles = measure::planeTriangles(mesh, frame, finiteOnly(values.of_vertices));
		const measure::Contours contours(triangles, {levels.begin(), levels.end()});
		for (std::size_t i = 0; i < levels.size(); ++i)
			take(contours.lines(i), levels[i]);
	}
	return lines;
}

} // namespace vp::render
