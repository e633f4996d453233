#include "contour/sheet_pieces.h"

#include "measure/components.h"

#include <algorithm>
#include <unordered_map>

namespace vp::contour
{

namespace
{

constexpr double kRounding = 1e-12; // share of the box's size; anything nearer to the sheet touches it

// Joins pieces that meet across faces with several neighbors.
void joinAcrossLinks(const grid::UnstructuredGrid& grid, std::uint32_t block, const surface::BlockSurface& surface,
                     const ClipBox& box, const mesh::SheetMesh& mesh, UnionFind& joined)
{
	std::unordered_map<CellId, std::uint32_t> vertex_of;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		if (mesh.polygon_cells[p].block == block)
			vertex_of.emplace(mesh.polygon_cells[p].cell, mesh.polygon(p)[0]);
	grid::CellFaces faces;
	for (const auto& [cell, vertex] : vertex_of)
	{
		grid.cellFaces(cell, faces);
		for (int f = 0; f < faces.size(); ++f)
		{
			int neighbors = 0;
			grid.forEachNeighbor(cell, f, [&](CellId) { ++neighbors; });
			if (neighbors < 2 || !box.meetsFace(grid, surface, faces[f]))
				continue;
			grid.forEachNeighbor(cell, f,
			                     [&, vertex = vertex](CellId neighbor)
			                     {
				                     if (const auto other = vertex_of.find(neighbor); other != vertex_of.end())
					                     joined.join(vertex, other->second);
			                     });
		}
	}
}

void keepPolygons(mesh::SheetMesh& mesh, const std::vector<bool>& kept)
{
	std::size_t polygon = 0;
	std::uint32_t corner = 0;
	for (std::size_t p = 0; p < kept.size(); ++p)
	{
		if (!kept[p])
			continue;
		const std::uint32_t begin = mesh.polygon_starts[p];
		const std::uint32_t end = mesh.polygon_starts[p + 1];
		mesh.polygon_starts[polygon] = corner;
		for (std::uint32_t c = begin; c < end; ++c, ++corner)
		{
			mesh.polygon_vertices[corner] = mesh.polygon_vertices[c];
			if (!mesh.is_added.empty())
				mesh.is_added[corner] = mesh.is_added[c];
		}
		mesh.polygon_cells[polygon++] = mesh.polygon_cells[p];
	}
	mesh.polygon_starts.resize(polygon + 1);
	mesh.polygon_starts[polygon] = corner;
	mesh.polygon_vertices.resize(corner);
	mesh.is_added.resize(mesh.is_added.empty() ? 0 : corner);
	mesh.polygon_cells.resize(polygon);
	mesh::dropUnusedVertices(mesh);
}

} // namespace

Pieces piecesOf(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces, const ClipBox& box,
                const mesh::SheetMesh& mesh)
{
	UnionFind joined = measure::joinedVertices(mesh);
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&blocks.blocks[b].grid); grid && grid->hasLinks())
			joinAcrossLinks(*grid, b, surfaces[b], box, mesh, joined);
	const double slack = kRounding * (glm::length(box.hi() - box.lo()) + glm::length(box.frame().origin));
	Pieces pieces{std::vector<std::uint32_t>(mesh.positions.size()),
	              std::vector<std::uint8_t>(mesh.positions.size(), 0)};
	for (std::uint32_t v = 0; v < pieces.of_vertex.size(); ++v)
	{
		const std::uint32_t piece = pieces.of_vertex[v] = joined.root(v);
		const double height = box.inBox(mesh.positions[v]).z;
		pieces.sides[piece] |= (height <= slack ? 1 : 0) | (height >= -slack ? 2 : 0);
	}
	return pieces;
}

bool keepTouching(const Pieces& pieces, mesh::SheetMesh& mesh)
{
	std::vector<bool> kept(mesh.polygons());
	for (std::size_t p = 0; p < kept.size(); ++p)
		kept[p] = pieces.sides[pieces.of_vertex[mesh.polygon(p)[0]]] == kBothSides;
	if (std::ranges::find(kept, false) == kept.end())
		return false;
	keepPolygons(mesh, kept);
	return true;
}

std::size_t keepOnSheet(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                        const ClipBox& box, mesh::SheetMesh& mesh)
{
	const Pieces pieces = piecesOf(blocks, surfaces, box, mesh);
	std::size_t count = 0;
	for (std::uint32_t v = 0; v < pieces.of_vertex.size(); ++v)
		count += pieces.of_vertex[v] == v && pieces.sides[v] == kBothSides;
	keepTouching(pieces, mesh);
	return count;
}

} // namespace vp::contour
