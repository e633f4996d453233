#include "mesh/build_mesh.h"

#include "base/key_numbers.h"
#include "mesh/cell_mesh.h"
#include "mesh/join_vertices.h"
#include "mesh/span_mesh.h"
#include "mesh/tidy_polygons.h"

namespace vp::mesh
{

namespace
{

// The boundary faces in the plane of one block: a corner of theirs is an edge of its own.
template <grid::Grid G>
void addFacesInPlane(const G& grid, const BlockCut& block, SheetMesh& mesh)
{
	KeyNumbers at_point(block.faces_in_plane.size());
	grid::CellFaces faces;
	for (const grid::BoundaryIndex::Face& face : block.faces_in_plane)
	{
		grid.cellFaces(face.cell, faces);
		for (const PointId p : faces[face.face])
		{
			const auto [number, is_new] = at_point.find(p, static_cast<std::uint32_t>(mesh.positions.size()));
			if (is_new)
			{
				mesh.edges.push_back({block.block, p, p, 0.0});
				mesh.positions.push_back(grid.point(p));
			}
			mesh.polygon_vertices.push_back(number);
		}
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({block.block, face.cell});
		++mesh.boundary_polygons;
	}
}

// What is left to do once the polygons of all cut cells are there. normal: of a flat mesh.
void finishMesh(const grid::BlockSet& blocks, std::span<const BlockCut> cuts, MeshCleanup doubts, const Vec3& normal,
                SheetMesh& mesh)
{
	for (const BlockCut& cut : cuts)
		std::visit([&](const auto& grid) { addFacesInPlane(grid, cut, mesh); }, blocks.blocks[cut.block].grid);

	const bool joins = doubts.at_points || mesh.boundary_polygons > 0 || blocks.blocks.size() > 1 ||
	                   blocks.interfaces.of(0) != nullptr;
	if (joins)
		joinVertices(blocks, mesh);
	if (joins || doubts.slivers)
	{
		tidyPolygons(mesh, normal);
		dropUnusedVertices(mesh);
	}
}

} // namespace

SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const BlockCut> cuts)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	const surface::Plane plane = sheet.plane();
	MeshCleanup doubts;
	for (const BlockCut& cut : cuts)
		if (cut.spans)
			doubts = doubts | addSpans(blocks.blocks[cut.block], cut.block, plane, sheet.normal, *cut.spans, mesh);

	for (const BlockCut& cut : cuts)
		if (cut.cut)
			doubts = doubts | addCells(blocks.blocks[cut.block], cut.block, plane, sheet.normal, *cut.cut, mesh);
	finishMesh(blocks, cuts, doubts, sheet.normal, mesh);
	return mesh;
}

SheetMesh buildMesh(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                    std::span<const BlockCut> cuts)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	mesh.flat = false;
	MeshCleanup doubts;
	for (const BlockCut& cut : cuts)
		doubts = doubts | addCells(blocks.blocks[cut.block], cut.block, surfaces[cut.block], Vec3(0.0), *cut.cut, mesh);
	finishMesh(blocks, cuts, doubts, Vec3(0.0), mesh);
	return mesh;
}

} // namespace vp::mesh
