#include "mesh/mesh_seams.h"

#include "grid/lone_faces.h"
#include "mesh/open_vertices.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace vp::mesh
{

namespace
{

using Face = grid::BoundaryIndex::Face;

/// Returns the open vertices. A joined vertex counts as the one that represents it. Polygons without area close no
/// ring.
OpenVertices openVertices(const SheetMesh& mesh, UnionFind& joined)
{
	OpenVertices open(mesh.positions.size());
	std::vector<std::uint32_t> corners;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		corners.clear();
		for (const std::uint32_t corner : mesh.polygon(p))
			if (const std::uint32_t vertex = joined.root(corner); corners.empty() || vertex != corners.back())
				corners.push_back(vertex);
		while (corners.size() > 1 && corners.back() == corners.front())
			corners.pop_back();
		if (corners.size() < 3)
			continue;
		std::uint32_t before = corners.back();
		for (const std::uint32_t vertex : corners)
			open.add(std::exchange(before, vertex), vertex);
	}
	return open;
}

/// Returns true if a vertex lies on a face of its cell: its edge, or the grid point at which it lies, is on the face.
bool liesOn(const EdgePoint& vertex, std::span<const PointId> face)
{
	const auto has = [&](PointId p) { return std::ranges::find(face, p) != face.end(); };
	return (vertex.t == 1.0 || has(vertex.lower)) && (vertex.t == 0.0 || has(vertex.higher));
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
		for (const std::uint32_t v : polygon)
		{
			if (!isOpen(v))
				continue;
			if (of.block != cell.block || of.cell != cell.cell)
			{
				cell = of;
				std::visit([&](const auto& grid) { grid.cellFaces(cell.cell, faces); }, blocks.blocks[cell.block].grid);
				taken.assign(static_cast<std::size_t>(faces.size()), 0);
			}
			for (int f = 0; f < faces.size(); ++f)
			{
				if (taken[static_cast<std::size_t>(f)] || !liesOn(mesh.edges[v], faces[f]))
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
