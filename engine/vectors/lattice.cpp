#include "vectors/lattice.h"

#include "measure/plane_triangles.h"
#include "measure/sheet_lookup.h"

#include <algorithm>
#include <cmath>

namespace vp::vectors
{

namespace
{

// A number from 0 to 1 that follows from a place: the mixing steps of SplitMix64 (Steele, Lea, Flood, "Fast Splittable
// Pseudorandom Number Generators", 2014).
double hashed(std::uint64_t place)
{
	place += 0x9E3779B97F4A7C15ull;
	place = (place ^ (place >> 30)) * 0xBF58476D1CE4E5B9ull;
	place = (place ^ (place >> 27)) * 0x94D049BB133111EBull;
	place ^= place >> 31;
	return static_cast<double>(place >> 11) * 0x1p-53;
}

Vec3 positionAt(const mesh::SheetMesh& mesh, const measure::SheetPlace& place)
{
	const auto corners = mesh.polygon(place.polygon);
	Vec3 mean(0.0);
	for (const std::uint32_t v : corners)
		mean += mesh.positions[v];
	mean /= static_cast<double>(corners.size());
	return place.weight[0] * mesh.positions[place.corner[0]] + place.weight[1] * mesh.positions[place.corner[1]] +
	       place.weight[2] * mean;
}

} // namespace

probe::Window boundsInPlane(const mesh::SheetMesh& mesh, const probe::Sheet& content)
{
	const std::vector<glm::dvec2> points = measure::planePoints(mesh, content);
	glm::dvec2 lo = points.front();
	glm::dvec2 hi = lo;
	for (const glm::dvec2& p : points)
	{
		lo = glm::min(lo, p);
		hi = glm::max(hi, p);
	}
	return {lo.x, hi.x, lo.y, hi.y};
}

SheetLattice launchLattice(const mesh::SheetMesh& mesh, const probe::Sheet& content, const LatticeChoice& choice)
{
	if (mesh.polygons() == 0)
		return {};
	return launchLattice(mesh, content, choice, content.window ? *content.window : boundsInPlane(mesh, content));
}

SheetLattice launchLattice(const mesh::SheetMesh& mesh, const probe::Sheet& content, const LatticeChoice& choice,
                           const probe::Window& area)
{
	SheetLattice lattice;
	lattice.spacing = std::max(area.width(), area.height()) / choice.along;
	const auto pointsAlong = [&](double side)
	{ return std::max(1u, static_cast<std::uint32_t>(std::lround(side / lattice.spacing))); };
	const std::uint32_t columns = pointsAlong(area.width());
	const std::uint32_t rows = pointsAlong(area.height());
	const measure::SheetLookup lookup(mesh, content);
	for (std::uint32_t row = 0; row < rows; ++row)
		for (std::uint32_t column = 0; column < columns; ++column)
		{
			const std::uint32_t seed = row * columns + column;
			const glm::dvec2 moved(hashed(2 * std::uint64_t(seed)), hashed(2 * std::uint64_t(seed) + 1));
			const glm::dvec2 in_lattice = glm::dvec2(column, row) + 0.5 + choice.jitter * (moved - 0.5);
			const glm::dvec2 uv(area.x0 + in_lattice.x * area.width() / columns,
			                    area.y0 + in_lattice.y * area.height() / rows);
			if (const auto place = lookup.at(uv))
				lattice.launches.push_back(
				    {positionAt(mesh, *place), place->cell.block, place->cell.cell, seed, place->inside});
		}
	return lattice;
}

} // namespace vp::vectors
