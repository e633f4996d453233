#include "mesh/listed_mesh.h"

#include "base/key_numbers.h"
#include "mesh/face_mesh.h"
#include "mesh/join_vertices.h"
#include "mesh/tidy_polygons.h"

#include <algorithm>
#include <array>

namespace vp::mesh
{

namespace
{

using surface::GridIndex;

// The edges of a hexahedron along i, j and k, {low, high} each, in an order that winds counter-clockwise seen from
// where the index grows.
constexpr std::array<std::array<std::array<std::uint8_t, 2>, 4>, 3> kEdges = {
    {{{{0, 1}, {3, 2}, {7, 6}, {4, 5}}}, {{{0, 3}, {4, 7}, {5, 6}, {1, 2}}}, {{{0, 4}, {1, 5}, {2, 6}, {3, 7}}}}};

// Adds the quadrilaterals of one block.
template <grid::Grid G>
class BlockSurface
{
public:
	BlockSurface(const G& grid, std::uint32_t block, const grid::LatticeCells& lattice, const GridIndex& at,
	             SheetMesh& mesh, std::size_t cells)
	    : grid_(grid), block_(block), lattice_(lattice), at_(at), mesh_(mesh), vertices_(cells + cells / 8)
	{
	}

	void add(std::span<const CellId> cells)
	{
		const std::size_t first = mesh_.polygon_vertices.size();
		double turn = 0.0;
		for (const CellId cell : cells)
			turn += addCell(cell);
		// A left-handed lattice winds the other way round.
		if (turn < 0.0)
			for (std::size_t at = first; at < mesh_.polygon_vertices.size(); at += 4)
				std::reverse(mesh_.polygon_vertices.begin() + static_cast<std::ptrdiff_t>(at),
				             mesh_.polygon_vertices.begin() + static_cast<std::ptrdiff_t>(at + 4));
	}

private:
	// The volume swept by the quadrilateral along its edges, negative in a left-handed cell.
	double addCell(CellId cell)
	{
		const grid::CellPoints points = grid_.cellPoints(cell);
		const double place = surface::placeIn(
		    lattice_.lattice().cellIndex(static_cast<CellId>(grid_.sourceCell(cell)))[at_.axis], at_.index);
		Vec3 along(0.0);
		for (const auto& [low, high] : kEdges[lattice_.axisInCells(at_.axis)])
		{
			mesh_.polygon_vertices.push_back(vertexOf(points.id[low], points.id[high], place));
			along += grid_.point(points.id[high]) - grid_.point(points.id[low]);
		}
		mesh_.polygon_starts.push_back(static_cast<std::uint32_t>(mesh_.polygon_vertices.size()));
		mesh_.polygon_cells.push_back({block_, cell});
		return glm::dot(doubleArea(mesh_, mesh_.polygon(mesh_.polygons() - 1)), along);
	}

	std::uint32_t vertexOf(PointId low, PointId high, double place)
	{
		const PointId lower = std::min(low, high);
		const PointId higher = std::max(low, high);
		const double t = low == lower ? place : 1.0 - place;
		// A grid point is one vertex, whatever edge it is reached by.
		const std::uint64_t key = t == 0.0   ? std::uint64_t(lower) << 32 | lower
		                          : t == 1.0 ? std::uint64_t(higher) << 32 | higher
		                                     : std::uint64_t(lower) << 32 | higher;
		const auto [number, is_new] = vertices_.find(key, static_cast<std::uint32_t>(mesh_.positions.size()));
		if (is_new)
		{
			const Vec3 a = grid_.point(lower);
			const Vec3 b = grid_.point(higher);
			mesh_.edges.push_back({block_, lower, higher, t});
			mesh_.positions.push_back(placeOnEdge(a, b, t));
		}
		return number;
	}

	const G& grid_;
	std::uint32_t block_;
	const grid::LatticeCells& lattice_;
	const GridIndex& at_;
	SheetMesh& mesh_;
	KeyNumbers vertices_;
};

} // namespace

SheetMesh gridIndexMesh(const grid::BlockSet& blocks, const GridIndex& at, std::span<const find::BlockCut> cuts)
{
	SheetMesh mesh = makeFaceMesh();
	for (std::uint32_t b = 0; b < cuts.size(); ++b)
		if (cuts[b].cutCells() > 0)
			std::visit(
			    [&](const auto& grid)
			    {
				    const auto lattice = grid::latticeCellsOf(blocks.blocks[b]);
				    BlockSurface(grid, b, *lattice, at, mesh, cuts[b].cells().cells.size()).add(cuts[b].cells().cells);
			    },
			    blocks.blocks[b].grid);
	joinVerticesOfFaces(blocks, blocks.interfaces, mesh);
	tidyPolygons(mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

SheetMesh patchMesh(const grid::BlockSet& blocks, const std::string& name, std::span<const find::BlockCut> cuts)
{
	SheetMesh mesh = makeFaceMesh();
	for (std::uint32_t b = 0; b < cuts.size(); ++b)
		std::visit(
		    [&](const auto& grid)
		    {
			    KeyNumbers shown(cuts[b].cells().cells.size());
			    for (const CellId cell : cuts[b].cells().cells)
				    shown.find(cell, 0);
			    BlockFaces faces(grid, b, mesh);
			    grid::CellFaces of_cell;
			    for (const grid::Patch::Face& face : grid::facesOfPatches(blocks, name, b))
			    {
				    if (!shown.has(face.cell))
					    continue;
				    grid.cellFaces(face.cell, of_cell);
				    faces.add(face.cell, of_cell[static_cast<int>(face.face)]);
			    }
		    },
		    blocks.blocks[b].grid);
	joinVerticesOfFaces(blocks, blocks.interfaces, mesh);
	tidyPolygons(mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

SheetMesh listedMesh(const grid::BlockSet& blocks, const find::ListedSurface& surface,
                     std::span<const find::BlockCut> cuts)
{
	if (const auto* patch = std::get_if<find::PatchName>(&surface))
		return patchMesh(blocks, patch->name, cuts);
	return gridIndexMesh(blocks, std::get<GridIndex>(surface), cuts);
}

} // namespace vp::mesh
