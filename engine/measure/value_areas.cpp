#include "measure/value_areas.h"

#include <cmath>

namespace vp::measure
{

ValueAreas valueAreas(const mesh::SheetMesh& mesh, std::span<const double> polygon_values)
{
	ValueAreas areas;
	for (std::size_t p = 0; p < mesh.polygons() - mesh.boundary_polygons; ++p)
	{
		if (std::isnan(polygon_values[p]))
			continue;
		const auto polygon = mesh.polygon(p);
		double area = 0.0;
		if (mesh.flat)
			area = 0.5 * glm::length(mesh::doubleArea(mesh, polygon));
		else
			mesh::forFan(mesh, polygon, [&](std::uint32_t, std::uint32_t, double part) { area += part; });
		areas[polygon_values[p]] += area;
	}
	return areas;
}

} // namespace vp::measure
