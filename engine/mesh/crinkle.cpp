#include "mesh/crinkle.h"

#include "find/span_cut.h"
#include "grid/lone_faces.h"
#include "grid/measure.h"
#include "mesh/build_mesh.h"
#include "mesh/face_mesh.h"
#include "mesh/join_vertices.h"
#include "mesh/tidy_polygons.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace vp::mesh
{

namespace
{

using Face = grid::BoundaryIndex::Face;

// The cells that a sheet shows.
class ShownCells
{
public:
	ShownCells(const grid::BlockSet& blocks, std::span<const ShownBlock> cuts) : keys_(0)
	{
		for (const ShownBlock& block : cuts)
		{
			const auto take = [&](CellId cell) { add(block.block, cell); };
			std::visit([&](const auto* cut) { find::forEachCutCell(blocks.blocks[block.block], *cut, take); },
			           block.found);
			for (const grid::BoundaryIndex::Face& face : block.faces_in_plane)
				add(block.block, face.cell);
		}
	}

	bool has(std::uint32_t block, CellId cell) const { return keys_.has(keyOf(block, cell)); }
	const std::vector<BlockCell>& all() const { return cells_; } // each once, block by block

private:
	static std::uint64_t keyOf(std::uint32_t block, CellId cell) { return std::uint64_t(block) << 32 | cell; }
	void add(std::uint32_t block, CellId cell)
	{
		if (keys_.find(keyOf(block, cell), 0).is_new)
			cells_.push_back({block, cell});
	}

	KeyNumbers keys_;
	std::vector<BlockCell> cells_;
};

double areaOf(const grid::Block& block, const Face& face)
{
	return std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces faces;
		    grid.cellFaces(face.cell, faces);
		    const std::span<const PointId> corners = faces[static_cast<int>(face.face)];
		    return glm::length(
		        grid::polygonArea(corners.size(), [&](std::size_t c) { return grid.point(corners[c]); }));
	    },
	    block.grid);
}

// Returns true if the faces of shown cells across a seam cover a face.
bool isCovered(const grid::BlockSet& blocks, const grid::Interfaces& seams, const ShownCells& shown,
               std::uint32_t block, const Face& face)
{
	constexpr double nearly_all = 0.99;
	if (!seams.of(block))
		return false;
	double area = 0.0;
	for (const grid::SeamLink& link : seams.of(block)->of(face.cell, face.face))
		if (shown.has(link.block, link.other))
		{
			if (link.hang != grid::Hang::large)
				return true;
			area += areaOf(blocks.blocks[link.block], {link.other, link.other_face});
		}
	return area > 0.0 && area >= nearly_all * areaOf(blocks.blocks[block], face);
}

// Says which faces have cells that are shown on both sides, where the blocks know their neighbors.
class KnownFaces
{
public:
	KnownFaces(const grid::BlockSet& blocks, const ShownCells& shown) : blocks_(blocks), shown_(shown) {}

	const grid::Interfaces& seams() const { return blocks_.interfaces; }
	template <grid::Grid G>
	bool isInner(const G& grid, const BlockCell& at, int face) const
	{
		bool has_neighbor = false;
		bool all_shown = true;
		grid.forEachNeighbor(at.cell, face,
		                     [&](CellId other)
		                     {
			                     has_neighbor = true;
			                     all_shown = all_shown && shown_.has(at.block, other);
		                     });
		return has_neighbor
		           ? all_shown
		           : isCovered(blocks_, seams(), shown_, at.block, {at.cell, static_cast<std::uint32_t>(face)});
	}

private:
	const grid::BlockSet& blocks_;
	const ShownCells& shown_;
};

// The same where the blocks do not: the faces of the shown cells are compared with each other.
class ComparedFaces
{
public:
	ComparedFaces(const grid::BlockSet& blocks, const ShownCells& shown) : outer_(blocks.blocks.size())
	{
		std::vector<grid::LoneFaces<Face>> faces(outer_.size());
		grid::CellFaces of_cell;
		for (const BlockCell& at : shown.all())
		{
			std::visit([&](const auto& grid) { grid.cellFaces(at.cell, of_cell); }, blocks.blocks[at.block].grid);
			for (int f = 0; f < of_cell.size(); ++f)
				faces[at.block].add(of_cell[f], {at.cell, static_cast<std::uint32_t>(f)});
		}
		for (std::size_t b = 0; b < outer_.size(); ++b)
			outer_[b] = faces[b].find();
		seams_ = grid::interfacesAmong(blocks, outer_);
		for (std::uint32_t b = 0; b < outer_.size(); ++b)
		{
			std::erase_if(outer_[b], [&](const Face& face) { return isCovered(blocks, seams_, shown, b, face); });
			std::ranges::sort(outer_[b], {}, placeOf);
		}
	}

	const grid::Interfaces& seams() const { return seams_; }
	template <grid::Grid G>
	bool isInner(const G&, const BlockCell& at, int face) const
	{
		const Face wanted{at.cell, static_cast<std::uint32_t>(face)};
		return !std::ranges::binary_search(outer_[at.block], placeOf(wanted), {}, placeOf);
	}

private:
	static std::uint64_t placeOf(const Face& face) { return std::uint64_t(face.cell) << 32 | face.face; }

	std::vector<std::vector<Face>> outer_;
	grid::Interfaces seams_;
};

// Adds the outer faces of shown cells, which are all of one block.
template <grid::Grid G, class Faces>
void addOuterFaces(const G& grid, std::span<const BlockCell> cells, const Faces& faces, SheetMesh& mesh)
{
	BlockFaces<G> mesh_faces(grid, cells.front().block, mesh);
	grid::CellFaces of_cell;
	for (const BlockCell& at : cells)
	{
		bool has_faces = false;
		for (int f = 0; f < grid.faceCount(at.cell); ++f)
		{
			if (faces.isInner(grid, at, f))
				continue;
			if (!has_faces)
				grid.cellFaces(at.cell, of_cell);
			has_faces = true;
			mesh_faces.add(at.cell, of_cell[f]);
		}
	}
}

template <class Faces>
SheetMesh outerFaces(const grid::BlockSet& blocks, std::span<const BlockCell> left, const Faces& faces)
{
	SheetMesh mesh = makeFaceMesh();
	while (!left.empty())
	{
		const std::uint32_t block = left.front().block;
		const auto end = std::ranges::find_if(left, [&](const BlockCell& at) { return at.block != block; });
		const std::span<const BlockCell> of_block(left.begin(), end);
		std::visit([&](const auto& grid) { addOuterFaces(grid, of_block, faces, mesh); }, blocks.blocks[block].grid);
		left = {end, left.end()};
	}
	joinVerticesOfFaces(blocks, faces.seams(), mesh);
	tidyPolygons(mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

} // namespace

SheetMesh crinkleMesh(const grid::BlockSet& blocks, std::span<const ShownBlock> cuts)
{
	const ShownCells shown(blocks, cuts);
	return grid::knowsSeams(blocks) ? outerFaces(blocks, shown.all(), KnownFaces(blocks, shown))
	                                : outerFaces(blocks, shown.all(), ComparedFaces(blocks, shown));
}

} // namespace vp::mesh
