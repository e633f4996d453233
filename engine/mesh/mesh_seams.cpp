#include "mesh/mesh_seams.h"

#include "grid/lone_faces.h"

#include <algorithm>
#include <span>
#include <vector>

namespace vp::mesh
{

namespace
{

using Face = grid::BoundaryIndex::Face;

/// Vigna's splitmix64: as good as random.
std::uint64_t mixed(std::uint64_t x)
{
	x += 0x9E3779B97F4A7C15ull;
	x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9ull;
	x = (x ^ x >> 27) * 0x94D049BB133111EBull;
	return x ^ x >> 31;
}

/// Per vertex: 0 where the polygons around it close a ring. Each adds a number for the neighbor that follows the vertex
/// and takes one away for the neighbor that comes before it, so that those of a ring cancel each other.
std::vector<std::uint64_t> openness(const SheetMesh& mesh, UnionFind& joined)
{
	std::vector<std::uint64_t> sums(mesh.positions.size());
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const std::span<const std::uint32_t> polygon = mesh.polygon(p);
		std::uint32_t before = joined.root(polygon.back());
		for (const std::uint32_t corner : polygon)
		{
			const std::uint32_t vertex = joined.root(corner);
			if (vertex == before)
				continue;
			sums[before] += mixed(vertex);
			sums[vertex] -= mixed(before);
			before = vertex;
		}
	}
	return sums;
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
	const std::vector<std::uint64_t> open = openness(mesh, joined);
	std::vector<grid::LoneFaces<Face>> candidates(blocks.blocks.size());
	grid::CellFaces faces;
	std::vector<std::uint8_t> taken;
	const auto isOpen = [&](std::uint32_t v) { return open[joined.root(v)] != 0; };
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
