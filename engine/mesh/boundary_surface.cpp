#include "mesh/boundary_surface.h"

#include "base/key_numbers.h"
#include "mesh/join_vertices.h"

namespace vp::mesh
{

namespace
{

// A face without its repeated corners; false where fewer than three are left.
bool distinctCorners(std::span<const PointId> face, std::vector<PointId>& corners)
{
	corners.clear();
	for (const PointId p : face)
		if (corners.empty() || corners.back() != p)
			corners.push_back(p);
	while (corners.size() > 1 && corners.front() == corners.back())
		corners.pop_back();
	return corners.size() > 2;
}

template <class G>
void addBlock(const G& grid, std::uint32_t number, const grid::BoundaryIndex& boundary, const grid::BlockSeams* seams,
              SheetMesh& mesh)
{
	KeyNumbers vertices(boundary.faces.size());
	grid::CellFaces faces;
	std::vector<PointId> corners;
	for (const grid::BoundaryIndex::Face& face : boundary.faces)
	{
		if (seams && !seams->of(face.cell, face.face).empty())
			continue;
		grid.cellFaces(face.cell, faces);
		if (!distinctCorners(faces[static_cast<int>(face.face)], corners))
			continue;
		for (const PointId p : corners)
		{
			const auto [vertex, is_new] = vertices.find(p, static_cast<std::uint32_t>(mesh.positions.size()));
			if (is_new)
			{
				mesh.positions.push_back(grid.point(p));
				mesh.edges.push_back({number, p, p, 0.0});
			}
			mesh.polygon_vertices.push_back(vertex);
		}
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({number, face.cell});
	}
}

} // namespace

SheetMesh boundarySurface(const grid::BlockSet& blocks)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		std::visit([&](const auto& grid)
		           { addBlock(grid, b, blocks.blocks[b].boundary, blocks.interfaces.of(b), mesh); },
		           blocks.blocks[b].grid);
	joinVertices(blocks, mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

} // namespace vp::mesh
