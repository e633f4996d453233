#pragma once

#include "grid/grid.h"

namespace vp::grid
{

// Returns the area vector of a polygon that is given by its points. It points along the normal by the right-hand rule.
// A warped polygon counts as the fan about the mean of its points.
template <class PointAt>
Vec3 polygonArea(std::size_t size, PointAt&& point_at)
{
	Vec3 twice(0.0);
	if (size < 3)
		return twice;
	const Vec3 origin = point_at(0);
	Vec3 previous = point_at(1) - origin;
	for (std::size_t i = 2; i < size; ++i)
	{
		const Vec3 next = point_at(i) - origin;
		twice += glm::cross(previous, next);
		previous = next;
	}
	return 0.5 * twice;
}

// Returns the volume that the faces of a cell enclose. Each face counts as the fan about the mean of its points. The
// volume is positive if faces run counter-clockwise seen from outside. `faces` is working memory for polyhedra.
template <Grid G>
double signedVolume(const G& grid, CellId cell, CellFaces& faces)
{
	const CellShape shape = grid.shape(cell);
	double sum = 0.0;
	if (shape == CellShape::polyhedron)
	{
		grid.cellFaces(cell, faces);
		if (faces.points.empty())
			return 0.0;
		const Vec3 origin = grid.point(faces.points[0]);
		for (int f = 0; f < faces.size(); ++f)
		{
			const auto point_at = [&](std::size_t i) { return grid.point(faces[f][i]) - origin; };
			Vec3 mean(0.0);
			for (std::size_t i = 0; i < faces[f].size(); ++i)
				mean += point_at(i) / static_cast<double>(faces[f].size());
			// The fan about m encloses a third of m . A with the origin.
			sum += glm::dot(mean, polygonArea(faces[f].size(), point_at));
		}
		return sum / 3.0;
	}
	const CellPoints ids = grid.cellPoints(cell);
	std::array<Vec3, kMaxShapePoints> p;
	const Vec3 origin = grid.point(ids.id[0]);
	for (int i = 0; i < ids.size; ++i)
		p[i] = grid.point(ids.id[i]) - origin;
	if (shape == CellShape::tetrahedron)
		return glm::dot(p[3], glm::cross(p[1], p[2])) / 6.0;
	const ShapeTopology& table = topology(shape);
	for (int f = 0; f < table.faces; ++f)
	{
		const auto& at = table.face[f];
		if (table.face_size[f] == 3)
			sum += 4.0 * glm::dot(p[at[0]], glm::cross(p[at[1]], p[at[2]]));
		else
			sum += glm::dot(p[at[0]] + p[at[1]] + p[at[2]] + p[at[3]],
			                glm::cross(p[at[2]] - p[at[0]], p[at[3]] - p[at[1]]));
	}
	return sum / 24.0;
}

} // namespace vp::grid
