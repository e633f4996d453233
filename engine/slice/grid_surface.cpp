#include "slice/grid_surface.h"

#include "slice/face_mesh.h"
#include "slice/join_vertices.h"
#include "slice/tidy_polygons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

namespace vp::slice
{

namespace
{

using surface::GridIndex;

// The edges of a hexahedron along i, j and k, {low, high} each, in an order that winds counter-clockwise seen from
// where the index grows.
constexpr std::array<std::array<std::array<std::uint8_t, 2>, 4>, 3> kEdges = {
    {{{{0, 1}, {3, 2}, {7, 6}, {4, 5}}}, {{{0, 3}, {4, 7}, {5, 6}, {1, 2}}}, {{{0, 4}, {1, 5}, {2, 6}, {3, 7}}}}};

std::optional<grid::LatticeCells> latticeReaching(const grid::Block& block, const GridIndex& at)
{
	std::optional<grid::LatticeCells> lattice = grid::latticeCellsOf(block);
	if (lattice && !(at.index >= 0.0 && at.index <= lattice->lattice().cells()[at.axis]))
		lattice.reset();
	return lattice;
}

std::array<std::uint32_t, 3> subscriptsOf(const grid::Block& block, const grid::Lattice& lattice, CellId cell)
{
	return lattice.cellIndex(
	    static_cast<CellId>(std::visit([&](const auto& grid) { return grid.sourceCell(cell); }, block.grid)));
}

class SurfaceCells
{
public:
	SurfaceCells(const grid::BlockSet& blocks, const GridIndex& at, std::span<const std::function<bool(CellId)>> admits)
	    : blocks_(blocks), at_(at), admits_(admits)
	{
		for (const grid::Block& block : blocks.blocks)
			lattices_.push_back(latticeReaching(block, at));
	}

	traverse::LaneCut ofBlock(std::uint32_t block) const
	{
		if (!lattices_[block])
			return traverse::oneGeneration({});
		const std::array<std::uint32_t, 3> cells = lattices_[block]->lattice().cells();
		const surface::GridLayers layers = surface::layersOf(at_.index, cells[at_.axis]);
		// The axis whose cells lie nearest in memory runs fastest.
		const int fast = at_.axis == 0 ? 1 : 0;
		const int slow = at_.axis == 2 ? 1 : 2;
		std::vector<CellId> shown;
		std::array<std::uint32_t, 3> index{};
		for (index[slow] = 0; index[slow] < cells[slow]; ++index[slow])
			for (index[fast] = 0; index[fast] < cells[fast]; ++index[fast])
				add(block, cellAt(block, index, layers), shown);
		return traverse::oneGeneration(std::move(shown));
	}

private:
	CellId cellAt(std::uint32_t block, std::array<std::uint32_t, 3> index, const surface::GridLayers& layers) const
	{
		index[at_.axis] = layers.cell;
		const CellId cell = lattices_[block]->at(index);
		if (cell != kNoCell || !layers.has_other_side)
			return cell;
		++index[at_.axis];
		return lattices_[block]->at(index);
	}

	void add(std::uint32_t block, CellId cell, std::vector<CellId>& cells) const
	{
		if (cell != kNoCell && admitted(block, cell) && !isShownAcross(block, cell))
			cells.push_back(cell);
	}

	bool admitted(std::uint32_t block, CellId cell) const
	{
		return admits_.empty() || !admits_[block] || admits_[block](cell);
	}

	// Whether the cell shows a face on a seam, and a cell before it shows what lies across.
	bool isShownAcross(std::uint32_t block, CellId cell) const
	{
		const grid::BlockSeams* seams = blocks_.interfaces.of(block);
		if (!seams)
			return false;
		const double place = surface::placeIn(
		    subscriptsOf(blocks_.blocks[block], lattices_[block]->lattice(), cell)[at_.axis], at_.index);
		if (place != 0.0 && place != 1.0)
			return false;
		const auto face = static_cast<std::uint32_t>(2 * lattices_[block]->axisInCells(at_.axis) + (place == 1.0));
		return std::ranges::any_of(seams->of(cell, face),
		                           [&](const grid::SeamLink& link) {
			                           return std::tie(link.block, link.other) < std::tie(block, cell) && isShown(link);
		                           });
	}

	bool isShown(const grid::SeamLink& link) const
	{
		const std::optional<grid::LatticeCells>& lattice = lattices_[link.block];
		if (!lattice || static_cast<int>(link.other_face / 2) != lattice->axisInCells(at_.axis) ||
		    !admitted(link.block, link.other))
			return false;
		const std::uint32_t layer = subscriptsOf(blocks_.blocks[link.block], lattice->lattice(), link.other)[at_.axis];
		return layer + link.other_face % 2 == at_.index;
	}

	const grid::BlockSet& blocks_;
	const GridIndex& at_;
	std::span<const std::function<bool(CellId)>> admits_;
	std::vector<std::optional<grid::LatticeCells>> lattices_; // per block, where the surface meets it
};

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
			mesh_.positions.push_back(t == 1.0 ? b : a + t * (b - a));
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

Status checkGridIndex(const grid::BlockSet& blocks, const surface::GridIndexRange& range)
{
	std::uint32_t most = 0;
	for (const grid::Block& block : blocks.blocks)
		if (const auto lattice = grid::latticeCellsOf(block))
			most = std::max(most, lattice->lattice().cells()[range.axis]);
	if (most == 0)
		return Error{ExitCode::input,
		             "the grid has no subscripts, being unstructured; cut it by a plane, with --normal"};
	for (const double index : {range.first, range.last})
		if (!(index >= 0.0 && index <= most))
			return Error{ExitCode::usage, fmt::format("{} runs from 0 to {} here; give an index within",
			                                          surface::axisName(range.axis), most)};
	return Nothing{};
}

std::vector<traverse::LaneCut> gridSurfaceCells(const grid::BlockSet& blocks, const GridIndex& at,
                                                std::span<const std::function<bool(CellId)>> admits)
{
	const SurfaceCells cells(blocks, at, admits);
	std::vector<traverse::LaneCut> cuts;
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		cuts.push_back(cells.ofBlock(b));
	return cuts;
}

SheetMesh gridSurfaceMesh(const grid::BlockSet& blocks, const GridIndex& at, std::span<const traverse::LaneCut> cells)
{
	SheetMesh mesh = makeFaceMesh();
	for (std::uint32_t b = 0; b < cells.size(); ++b)
		if (!cells[b].cells.empty())
			std::visit(
			    [&](const auto& grid)
			    {
				    const auto lattice = grid::latticeCellsOf(blocks.blocks[b]);
				    BlockSurface(grid, b, *lattice, at, mesh, cells[b].cells.size()).add(cells[b].cells);
			    },
			    blocks.blocks[b].grid);
	joinVertices(blocks, mesh, true);
	tidyPolygons(mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

} // namespace vp::slice
