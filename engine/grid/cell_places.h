#pragma once

#include "grid/grid.h"

#include <span>
#include <vector>

namespace vp::grid
{

// The faces of a cell with the places of their points.
struct CellPlaces
{
	CellFaces faces;
	std::vector<Vec3> places;
	Vec3 center{0.0};

	template <Grid G>
	void fetch(const G& grid, CellId cell)
	{
		grid.cellFaces(cell, faces);
		places.clear();
		for (const PointId p : faces.points)
			places.push_back(grid.point(p));
		center = cellCenter(grid, cell);
	}
};

// Returns true if the point lies inside the cell, deeper than mere contact. The cell is taken as the tetrahedra between
// its center and the fans of its faces. Cells that share a face share its fan.
inline bool liesInside(const CellPlaces& cell, const Vec3& point)
{
	// The depth of contact, as a part of the way from a face to the center of the cell.
	constexpr double kDepth = 1e-2;
	constexpr double kRim = 1e-9; // between the tetrahedra
	for (int f = 0; f < cell.faces.size(); ++f)
	{
		const std::span<const Vec3> face(cell.places.data() + cell.faces.starts[f], cell.faces[f].size());
		Vec3 middle(0.0);
		for (const Vec3& p : face)
			middle += p / static_cast<double>(face.size());
		for (std::size_t i = 0; i < face.size(); ++i)
		{
			const Vec3 a = middle - cell.center;
			const Vec3 b = face[i] - cell.center;
			const Vec3 c = face[(i + 1) % face.size()] - cell.center;
			const double volume = glm::dot(a, glm::cross(b, c));
			if (volume == 0.0)
				continue;
			const Vec3 p = point - cell.center;
			const double wa = glm::dot(p, glm::cross(b, c)) / volume;
			const double wb = glm::dot(a, glm::cross(p, c)) / volume;
			const double wc = glm::dot(a, glm::cross(b, p)) / volume;
			if (wa >= -kRim && wb >= -kRim && wc >= -kRim && wa + wb + wc <= 1.0 - kDepth)
				return true;
		}
	}
	return false;
}

} // namespace vp::grid
