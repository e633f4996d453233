#pragma once

#include "base/key_numbers.h"
#include "grid/cell_places.h"
#include "mesh/sheet_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace vp::mesh
{

// An empty mesh for faces of cells.
inline SheetMesh makeFaceMesh()
{
	SheetMesh mesh;
	mesh.flat = false;
	mesh.polygon_starts.push_back(0);
	return mesh;
}

// Adds faces of the cells of one block to a mesh, with the grid's points as vertices.
template <grid::Grid G>
class BlockFaces
{
public:
	BlockFaces(const G& grid, std::uint32_t block, SheetMesh& mesh)
	    : grid_(grid), block_(block), mesh_(mesh), vertices_(0)
	{
	}

	// Turned to face away from the cell: left-handed lattices and polyhedra list faces either way round. All faces of a
	// cell are added one after the other.
	void add(CellId cell, std::span<const PointId> face)
	{
		const std::size_t first = mesh_.polygon_vertices.size();
		for (const PointId p : face)
			mesh_.polygon_vertices.push_back(vertexOf(p));
		mesh_.polygon_starts.push_back(static_cast<std::uint32_t>(mesh_.polygon_vertices.size()));
		mesh_.polygon_cells.push_back({block_, cell});
		const std::span vertices = std::span(mesh_.polygon_vertices).subspan(first);
		if (facesInward(cell, vertices))
			std::reverse(vertices.begin(), vertices.end());
	}

private:
	bool facesInward(CellId cell, std::span<const std::uint32_t> vertices)
	{
		const Vec3 area = doubleArea(mesh_, vertices);
		Vec3 middle(0.0);
		for (const std::uint32_t v : vertices)
			middle += mesh_.positions[v] / static_cast<double>(vertices.size());
		const bool away = glm::dot(area, middle - grid::cellCenter(grid_, cell)) < 0.0;
		if (grid_.shape(cell) != grid::CellShape::polyhedron)
			return away;
		if (cell != concave_asked_)
		{
			concave_asked_ = cell;
			places_.fetch(grid_, cell);
			is_concave_ = !grid::isStarAbout(places_, places_.center);
		}
		return is_concave_ ? isInside(vertices, area).value_or(away) : away;
	}

	// Whether the cell lies on the side of a face's normal; its center does not tell if the cell is concave or has
	// holes. A triangle of the face's fan that runs with the face tells.
	std::optional<bool> isInside(std::span<const std::uint32_t> vertices, const Vec3& area) const
	{
		constexpr double kBeside = 1e-6; // share of the triangle's size
		Vec3 middle(0.0);
		for (const std::uint32_t v : vertices)
			middle += mesh_.positions[v] / static_cast<double>(vertices.size());
		double most = 0.0;
		Vec3 at(0.0);
		for (std::size_t i = 0; i < vertices.size(); ++i)
		{
			const Vec3& a = mesh_.positions[vertices[i]];
			const Vec3& b = mesh_.positions[vertices[(i + 1) % vertices.size()]];
			if (const double part = glm::dot(glm::cross(a - middle, b - middle), area); part > most)
			{
				most = part;
				at = (a + b + middle) / 3.0;
			}
		}
		const double length = glm::length(area);
		if (!(most > 0.0) || !(length > 0.0))
			return std::nullopt;
		return grid::isEnclosed(places_, at + kBeside * std::sqrt(most / length) / length * area);
	}

	std::uint32_t vertexOf(PointId p)
	{
		const auto [number, is_new] = vertices_.find(p, static_cast<std::uint32_t>(mesh_.positions.size()));
		if (is_new)
		{
			mesh_.edges.push_back({block_, p, p, 0.0});
			mesh_.positions.push_back(grid_.point(p));
		}
		return number;
	}

	const G& grid_;
	std::uint32_t block_;
	SheetMesh& mesh_;
	KeyNumbers vertices_;
	CellId concave_asked_ = kNoCell; // the cell of the next two
	bool is_concave_ = false;
	grid::CellPlaces places_;
};

} // namespace vp::mesh
