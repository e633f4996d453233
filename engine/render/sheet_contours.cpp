#include "render/sheet_contours.h"

#include "slice/cell_steps.h"
#include "slice/contour_lines.h"

namespace vp::render
{

std::vector<LevelLine> levelLines(const slice::SheetMesh& mesh, const probe::Frame& frame, const SheetValues& values,
                                  std::span<const double> levels)
{
	std::vector<LevelLine> lines;
	const auto take = [&](std::vector<slice::PlaneLine> found, double level)
	{
		for (slice::PlaneLine& line : found)
			lines.push_back({level, std::move(line)});
	};
	if (!values.of_polygons.empty())
	{
		const std::vector<glm::dvec2> points = slice::planePoints(mesh, frame);
		for (const double level : levels)
			take(slice::stepLines(mesh, points, values.of_polygons, level), level);
	}
	else if (!values.of_vertices.empty())
	{
		const slice::PlaneTriangles triangles = slice::planeTriangles(mesh, frame, values.of_vertices);
		const slice::Contours contours(triangles, {levels.begin(), levels.end()});
		for (std::size_t i = 0; i < levels.size(); ++i)
			take(contours.lines(i), levels[i]);
	}
	return lines;
}

} // namespace vp::render
