#include "mesh/part_edges.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace vp::mesh
{

namespace
{

bool splitsCells(const grid::Block& block)
{
	const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid);
	return grid && grid->splitsCells();
}

struct PartEdge
{
	std::uint32_t low; // vertices
	std::uint32_t high;
	std::uint32_t block;
	std::uint32_t cell; // its number in the file
	std::uint32_t entry;

	auto key() const { return std::tie(low, high, block, cell); }
};

struct WholeCell
{
	double area = 0.0;
	double around = 0.0; // length of its rim
};

class PartEdgeFinder
{
public:
	PartEdgeFinder(const grid::BlockSet& blocks, const SheetMesh& mesh) : mesh_(mesh)
	{
		for (const grid::Block& block : blocks.blocks)
			grids_.push_back(splitsCells(block) ? std::get_if<grid::UnstructuredGrid>(&block.grid) : nullptr);
	}

	PartEdges find()
	{
		markEdges();
		measureCells();
		return std::move(found_);
	}

private:
	std::uint32_t cellOf(std::size_t polygon) const
	{
		const auto [block, cell] = mesh_.polygon_cells[polygon];
		return static_cast<std::uint32_t>(grids_[block]->sourceCell(cell));
	}
	bool isOfPart(std::size_t polygon) const { return grids_[mesh_.polygon_cells[polygon].block] != nullptr; }

	// Two polygons of one cell meet along an edge within it.
	void markEdges()
	{
		std::vector<PartEdge> edges;
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
		{
			if (!isOfPart(p))
				continue;
			const std::uint32_t begin = mesh_.polygon_starts[p];
			const std::uint32_t end = mesh_.polygon_starts[p + 1];
			for (std::uint32_t i = begin; i < end; ++i)
			{
				const auto [low, high] =
				    std::minmax(mesh_.polygon_vertices[i], mesh_.polygon_vertices[i + 1 < end ? i + 1 : begin]);
				edges.push_back({low, high, mesh_.polygon_cells[p].block, cellOf(p), i});
			}
		}
		std::sort(edges.begin(), edges.end(), [](const PartEdge& a, const PartEdge& b) { return a.key() < b.key(); });
		found_.is_inner.assign(mesh_.polygon_vertices.size(), 0);
		for (std::size_t i = 1; i < edges.size(); ++i)
			if (edges[i - 1].key() == edges[i].key())
				found_.is_inner[edges[i - 1].entry] = found_.is_inner[edges[i].entry] = 1;
	}

	void measureCells()
	{
		std::unordered_map<std::uint64_t, WholeCell> cells;
		const auto keyOf = [&](std::size_t p)
		{ return std::uint64_t(mesh_.polygon_cells[p].block) << 32 | std::uint64_t(cellOf(p)); };
		std::vector<double> own(mesh_.polygons(), 0.0);
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
		{
			if (!isOfPart(p))
				continue;
			WholeCell& cell = cells[keyOf(p)];
			const auto polygon = mesh_.polygon(p);
			const double area = 0.5 * glm::length(doubleArea(mesh_, polygon));
			double around = 0.0;
			for (std::size_t i = 0; i < polygon.size(); ++i)
			{
				const double length =
				    glm::length(mesh_.positions[polygon[(i + 1) % polygon.size()]] - mesh_.positions[polygon[i]]);
				around += length;
				if (!found_.is_inner[mesh_.polygon_starts[p] + i])
					cell.around += length;
			}
			cell.area += area;
			own[p] = around > 0.0 ? area / around : 0.0;
		}
		found_.widths.assign(mesh_.polygons(), 1.0f);
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
			if (isOfPart(p) && own[p] > 0.0)
				if (const WholeCell& cell = cells[keyOf(p)]; cell.around > 0.0)
					found_.widths[p] = static_cast<float>(std::max(1.0, cell.area / cell.around / own[p]));
	}

	const SheetMesh& mesh_;
	std::vector<const grid::UnstructuredGrid*> grids_; // null where no cell has parts
	PartEdges found_;
};

} // namespace

bool hasParts(const grid::BlockSet& blocks)
{
	return std::ranges::any_of(blocks.blocks, splitsCells);
}

PartEdges partEdges(const grid::BlockSet& blocks, const SheetMesh& mesh)
{
	return hasParts(blocks) ? PartEdgeFinder(blocks, mesh).find() : PartEdges{};
}

} // namespace vp::mesh
