#pragma once

#include "base/key_numbers.h"
#include "mesh/sheet_mesh.h"

#include <algorithm>
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

	// Turned to face away from the cell: left-handed lattices and polyhedra list faces either way round.
	void add(CellId cell, std::span<const PointId> face)
	{
		const std::size_t first = mesh_.polygon_vertices.size();
		for (const PointId p : face)
			mesh_.polygon_vertices.push_back(vertexOf(p));
		mesh_.polygon_starts.push_back(static_cast<std::uint32_t>(mesh_.polygon_vertices.size()));
		mesh_.polygon_cells.push_back({block_, cell});
		const std::span vertices = std::span(mesh_.polygon_vertices).subspan(first);
		Vec3 middle(0.0);
		for (const std::uint32_t v : vertices)
			middle += mesh_.positions[v] / static_cast<double>(vertices.size());
		if (glm::dot(doubleArea(mesh_, vertices), middle - grid::cellCenter(grid_, cell)) < 0.0)
			std::reverse(vertices.begin(), vertices.end());
	}

private:
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
};

} // namespace vp::mesh
