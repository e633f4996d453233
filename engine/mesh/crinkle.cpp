#include "mesh/crinkle.h"

#include "find/span_cut.h"
#include "mesh/build_mesh.h"
#include "mesh/face_mesh.h"
#include "mesh/join_vertices.h"
#include "mesh/tidy_polygons.h"

#include <algorithm>

namespace vp::mesh
{

namespace
{

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

// Adds the outer faces of the cells of one block.
template <grid::Grid G>
class BlockCrinkle
{
public:
	BlockCrinkle(const G& grid, std::uint32_t block, const grid::BlockSeams* seams, const ShownCells& shown,
	             SheetMesh& mesh)
	    : grid_(grid), seams_(seams), shown_(shown), mesh_faces_(grid, block, mesh)
	{
	}

	void add(const BlockCell& at)
	{
		bool has_faces = false;
		for (int f = 0; f < grid_.faceCount(at.cell); ++f)
		{
			if (isInner(at, f))
				continue;
			if (!has_faces)
				grid_.cellFaces(at.cell, faces_);
			has_faces = true;
			mesh_faces_.add(at.cell, faces_[f]);
		}
	}

private:
	bool isInner(const BlockCell& at, int face) const
	{
		bool has_neighbor = false;
		bool all_shown = true;
		const auto meet = [&](std::uint32_t block, CellId other)
		{
			has_neighbor = true;
			all_shown = all_shown && shown_.has(block, other);
		};
		grid_.forEachNeighbor(at.cell, face, [&](CellId other) { meet(at.block, other); });
		if (!has_neighbor && seams_)
			for (const grid::SeamLink& link : seams_->of(at.cell, static_cast<std::uint32_t>(face)))
				meet(link.block, link.other);
		return has_neighbor && all_shown;
	}

	const G& grid_;
	const grid::BlockSeams* seams_;
	const ShownCells& shown_;
	BlockFaces<G> mesh_faces_;
	grid::CellFaces faces_;
};

} // namespace

SheetMesh crinkleMesh(const grid::BlockSet& blocks, std::span<const ShownBlock> cuts)
{
	const ShownCells shown(blocks, cuts);
	SheetMesh mesh = makeFaceMesh();
	std::span<const BlockCell> left = shown.all();
	while (!left.empty())
	{
		const std::uint32_t block = left.front().block;
		const auto end = std::ranges::find_if(left, [&](const BlockCell& at) { return at.block != block; });
		std::visit(
		    [&](const auto& grid)
		    {
			    BlockCrinkle crinkle(grid, block, blocks.interfaces.of(block), shown, mesh);
			    for (auto at = left.begin(); at != end; ++at)
				    crinkle.add(*at);
		    },
		    blocks.blocks[block].grid);
		left = {end, left.end()};
	}
	joinVertices(blocks, mesh, true);
	tidyPolygons(mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

} // namespace vp::mesh
