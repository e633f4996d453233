#include "mesh/mesh_seams.h"

#include "grid/lone_faces.h"
#include "mesh/open_vertices.h"

#include <algorithm>
#include <span>
#include <vector>

namespace vp::mesh
{

namespace
{

using Face = grid::BoundaryIndex::Face;

/// Of the vertices that others have been joined to.
OpenVertices openVertices(const SheetMesh& mesh, UnionFind& joined)
{
	OpenVertices open(mesh.positions.size());
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const std::span<const std::uint32_t> polygon = mesh.polygon(p);
		std::uint32_t before = joined.root(polygon.back());
		for (const std::uint32_t corner : polygon)
		{
			const std::uint32_t vertex = joined.root(corner);
			if (vertex != before)
				open.add(before, vertex);
			before = vertex;
		}
	}
	return open;
}

/// Whether an edge's or a grid point's vertex lies on a face, as ids have it.
bool liesOn(const EdgePoint& vertex, std::span<const PointId> face)
{
	const auto has = [&](PointId p) { return std::ranges::find(face, p) != face.end(); };
	return has(vertex.lower) && has(vertex.higher);
}

} // namespace

grid::Interfaces seamsOfMesh(const grid::BlockSet& blocks, const SheetMesh& mesh, UnionFind& joined)
{
	const OpenVertices open = openVertices(mesh, joined);
	std::vector<grid::LoneFaces<Face>> candidates(blocks.blocks.size());
	grid::CellFaces faces;
	std::vector<std::uint8_t> taken;
	const auto isOpen = [&](std::uint32_t v) { return open.isOpen(joined.root(v)); };
	// Faces of one cell by its polygon; a twisted cell has several, one after the other.
	BlockCell cell{~0u, kNoCell};
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const std::span<const std::uint32_t> polygon = mesh.polygon(p);
		const BlockCell of = mesh.polygon_cells[p];
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			const std::uint32_t v = polygon[i];
			const std::uint32_t w = polygon[i + 1 < polygon.size() ? i + 1 : 0];
			if (!isOpen(v) || !isOpen(w))
				continue;
			if (of.block != cell.block || of.cell != cell.cell)
			{
				cell = of;
				std::visit([&](const auto& grid) { grid.cellFaces(cell.cell, faces); }, blocks.blocks[cell.block].grid);
				taken.assign(static_cast<std::size_t>(faces.size()), 0);
			}
			for (int f = 0; f < faces.size(); ++f)
			{
				if (taken[static_cast<std::size_t>(f)] || !liesOn(mesh.edges[v], faces[f]) ||
				    !liesOn(mesh.edges[w], faces[f]))
					continue;
				taken[static_cast<std::size_t>(f)] = 1;
				candidates[cell.block].add(faces[f], {cell.cell, static_cast<std::uint32_t>(f)});
			}
		}
	}
	std::vector<std::vector<Face>> lone;
	for (grid::LoneFaces<Face>& of_block : candidates)
		lone.push_back(of_block.find());
	return grid::interfacesAmong(blocks, lone);
}

} // namespace vp::mesh
