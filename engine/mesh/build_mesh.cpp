#include "mesh/build_mesh.h"

#include "base/key_numbers.h"
#include "mesh/cell_mesh.h"
#include "mesh/join_vertices.h"
#include "mesh/span_mesh.h"
#include "mesh/tidy_polygons.h"

#include <algorithm>
#include <span>

namespace vp::mesh
{

namespace
{

// Turns a polygon to run counter-clockwise seen from a place.
void turnToward(const Vec3& place, const SheetMesh& mesh, std::span<std::uint32_t> polygon)
{
	if (glm::dot(doubleArea(mesh, polygon), place - mesh.positions[polygon[0]]) < 0.0)
		std::ranges::reverse(polygon);
}

// The boundary faces in the plane of one block: a corner of theirs is an edge of its own. Their cells lie above the
// surface, and so does a curved one's normal. tidyPolygons() turns those in a plane.
template <grid::Grid G>
void addFacesInPlane(const G& grid, const ShownBlock& block, SheetMesh& mesh)
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
		if (!mesh.flat)
			turnToward(grid::cellCenter(grid, face.cell), mesh,
			           std::span(mesh.polygon_vertices).subspan(mesh.polygon_starts.back()));
		mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
		mesh.polygon_cells.push_back({block.block, face.cell});
		++mesh.boundary_polygons;
	}
}

// The last steps, once the mesh has the polygons of all cut cells. normal: the normal of a flat mesh.
void finishMesh(const grid::BlockSet& blocks, std::span<const ShownBlock> shown, MeshCleanup cleanup,
                const Vec3& normal, Hanging hanging, SheetMesh& mesh)
{
	for (const ShownBlock& block : shown)
		std::visit([&](const auto& grid) { addFacesInPlane(grid, block, mesh); }, blocks.blocks[block.block].grid);

	const bool joins = cleanup.at_points || mesh.boundary_polygons > 0 || blocks.blocks.size() > 1 ||
	                   blocks.interfaces.of(0) != nullptr;
	// Where seams are not known, a block may meet itself.
	const bool joined = (joins || !grid::knowsSeams(blocks)) && joinVertices(blocks, mesh, hanging);
	if (joins || joined || cleanup.slivers)
	{
		tidyPolygons(mesh, normal);
		dropUnusedVertices(mesh);
	}
}

} // namespace

ShownBlock shownBlock(std::uint32_t block, const find::BlockCut& cut,
                      std::span<const grid::BoundaryIndex::Face> faces_in_plane)
{
	ShownBlock shown{block, {}, faces_in_plane};
	std::visit([&](const auto& found) { shown.found = &found; }, cut.found);
	return shown;
}

SheetMesh buildMesh(const grid::BlockSet& blocks, const probe::Sheet& sheet, std::span<const ShownBlock> shown,
                    Hanging hanging)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	const surface::Plane plane = sheet.plane();
	MeshCleanup cleanup;
	// Vertices of runs come first: their numbers are known before anything is written.
	for (const ShownBlock& block : shown)
		if (const auto* spans = std::get_if<const find::SpanCut*>(&block.found))
			cleanup = cleanup | addSpans(blocks.blocks[block.block], block.block, plane, sheet.normal, **spans, mesh);
	for (const ShownBlock& block : shown)
		if (const auto* cells = std::get_if<const find::CellCut*>(&block.found))
			cleanup = cleanup | addCells(blocks.blocks[block.block], block.block, plane, sheet.normal, **cells, mesh);
	finishMesh(blocks, shown, cleanup, sheet.normal, hanging, mesh);
	return mesh;
}

SheetMesh buildMesh(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                    std::span<const ShownBlock> shown, Hanging hanging)
{
	SheetMesh mesh;
	mesh.polygon_starts.push_back(0);
	mesh.flat = false;
	MeshCleanup cleanup;
	for (const ShownBlock& block : shown)
		cleanup = cleanup | addCells(blocks.blocks[block.block], block.block, surfaces[block.block], Vec3(0.0),
		                             *std::get<const find::CellCut*>(block.found), mesh);
	finishMesh(blocks, shown, cleanup, Vec3(0.0), hanging, mesh);
	return mesh;
}

} // namespace vp::mesh
