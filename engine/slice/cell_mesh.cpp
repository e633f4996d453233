#include "slice/cell_mesh.h"

#include "slice/cell_polygons.h"
#include "slice/edge_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace vp::slice
{

namespace
{

constexpr std::size_t kPartCells = 4096;

// The polygons of some cells on end, and where they go in the mesh.
struct Part
{
	std::vector<std::uint64_t> keys;   // per corner: the lower point of its edge, and in the low half the higher
	std::vector<std::uint32_t> places; // per corner: of its edge in the table
	std::vector<std::uint32_t> ends;   // per polygon: one past its last corner
	std::vector<CellId> cells;         // per polygon
	std::size_t twisted = 0;
	std::uint32_t owned = 0; // vertices that it is the first to meet
	std::uint32_t first_vertex = 0;
	std::uint32_t first_corner = 0;
	std::uint32_t first_polygon = 0;
};

template <grid::Grid G>
class CellMesh
{
public:
	CellMesh(const G& grid, std::uint32_t block, const surface::Plane& plane, const Vec3& normal,
	         const traverse::LaneCut& cut, SheetMesh& mesh)
	    : grid_(grid), block_(block), plane_(plane), normal_(normal), cut_(cut), mesh_(mesh),
	      parts_((cut.cells.size() + kPartCells - 1) / kPartCells)
	{
	}

	MeshDoubts add()
	{
		forParts([&](std::size_t p) { collect(p); });
		// A grid of tables has fewer edges than cells or somewhat more; one of polyhedra may have many.
		for (std::size_t expected = cut_.cut_cells; !findEdges(expected); expected *= 4)
			;
		forParts([&](std::size_t p) { countOwned(p); });
		placeParts();
		forParts([&](std::size_t p) { addVertices(p); });
		forParts([&](std::size_t p) { addPolygons(p); });
		return {at_points_, slivers_};
	}

private:
	template <class Do>
	void forParts(Do&& act)
	{
		tbb::parallel_for(std::size_t(0), parts_.size(), act);
	}

	void collect(std::size_t p)
	{
		Part& part = parts_[p];
		const std::size_t begin = p * kPartCells;
		const std::size_t end = std::min(begin + kPartCells, cut_.cells.size());
		part.keys.reserve(5 * kPartCells);
		part.ends.reserve(kPartCells);
		part.cells.reserve(kPartCells);
		CellPolygons<G> polygons(grid_, plane_);
		for (std::size_t i = begin; i < end; ++i)
		{
			if (!(cut_.words[i] & shared::kWordCut))
				continue;
			part.twisted +=
			    polygons.visit(cut_.cells[i], cut_.words[i],
			                   [&](const auto& edges)
			                   {
				                   for (const auto& [a, b] : edges)
					                   part.keys.push_back(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b));
				                   part.ends.push_back(static_cast<std::uint32_t>(part.keys.size()));
				                   part.cells.push_back(cut_.cells[i]);
			                   });
		}
	}

	// In the order of the cells.
	static std::uint64_t rankOf(std::size_t part, std::size_t corner) { return std::uint64_t(part) << 32 | corner; }

	bool findEdges(std::size_t expected)
	{
		table_.emplace(expected);
		std::atomic<bool> fits{true};
		forParts(
		    [&](std::size_t p)
		    {
			    constexpr std::size_t kAhead = 12;
			    Part& part = parts_[p];
			    part.places.resize(part.keys.size());
			    for (std::size_t c = 0; c < part.keys.size(); ++c)
			    {
				    if (c + kAhead < part.keys.size())
					    table_->prefetch(part.keys[c + kAhead]);
				    part.places[c] = table_->find(part.keys[c], rankOf(p, c));
				    if (part.places[c] == EdgeTable::kFull)
				    {
					    fits = false;
					    return;
				    }
			    }
		    });
		return fits;
	}

	void countOwned(std::size_t p)
	{
		for (std::size_t c = 0; c < parts_[p].places.size(); ++c)
			parts_[p].owned += table_->isOwner(parts_[p].places[c], rankOf(p, c));
	}

	void placeParts()
	{
		auto vertex = static_cast<std::uint32_t>(mesh_.positions.size());
		auto corner = static_cast<std::uint32_t>(mesh_.polygon_vertices.size());
		auto polygon = static_cast<std::uint32_t>(mesh_.polygons());
		for (Part& part : parts_)
		{
			part.first_vertex = vertex;
			part.first_corner = corner;
			part.first_polygon = polygon;
			vertex += part.owned;
			corner += static_cast<std::uint32_t>(part.keys.size());
			polygon += static_cast<std::uint32_t>(part.cells.size());
			mesh_.cells_twisted += part.twisted;
		}
		mesh_.positions.resize(vertex);
		mesh_.edges.resize(vertex);
		mesh_.polygon_vertices.resize(corner);
		mesh_.polygon_starts.resize(polygon + std::size_t(1));
		mesh_.polygon_cells.resize(polygon);
	}

	void addVertices(std::size_t p)
	{
		const Part& part = parts_[p];
		std::uint32_t next = part.first_vertex;
		bool at_points = false;
		for (std::size_t c = 0; c < part.keys.size(); ++c)
		{
			if (!table_->isOwner(part.places[c], rankOf(p, c)))
				continue;
			table_->setNumber(part.places[c], next);
			const auto lower = static_cast<PointId>(part.keys[c] >> 32);
			const auto higher = static_cast<PointId>(part.keys[c]);
			const Vec3 a = grid_.point(lower);
			const Vec3 b = grid_.point(higher);
			const double da = plane_.signedDistance(a);
			const double t = da / (da - plane_.signedDistance(b)); // the signs differ
			mesh_.edges[next] = {block_, lower, higher, t};
			mesh_.positions[next] = t == 1.0 ? b : a + t * (b - a);
			at_points = at_points || t == 0.0 || t == 1.0;
			++next;
		}
		if (at_points)
			at_points_ = true;
	}

	void addPolygons(std::size_t p)
	{
		const Part& part = parts_[p];
		for (std::size_t c = 0; c < part.places.size(); ++c)
			mesh_.polygon_vertices[part.first_corner + c] = table_->number(part.places[c]);
		bool slivers = false;
		std::uint32_t begin = part.first_corner;
		for (std::size_t i = 0; i < part.cells.size(); ++i)
		{
			const std::uint32_t end = part.first_corner + part.ends[i];
			slivers = !turnPolygon(mesh_, normal_, {&mesh_.polygon_vertices[begin], end - begin}) || slivers;
			mesh_.polygon_starts[part.first_polygon + i + 1] = end;
			mesh_.polygon_cells[part.first_polygon + i] = {block_, part.cells[i]};
			begin = end;
		}
		if (slivers)
			slivers_ = true;
	}

	const G& grid_;
	std::uint32_t block_;
	const surface::Plane& plane_;
	const Vec3 normal_;
	const traverse::LaneCut& cut_;
	SheetMesh& mesh_;
	std::optional<EdgeTable> table_;
	std::vector<Part> parts_;
	std::atomic<bool> at_points_{false};
	std::atomic<bool> slivers_{false};
};

} // namespace

MeshDoubts addCells(const grid::Block& block, std::uint32_t number, const surface::Plane& plane, const Vec3& normal,
                    const traverse::LaneCut& cut, SheetMesh& mesh)
{
	if (cut.cut_cells == 0)
		return {};
	return std::visit([&](const auto& grid) { return CellMesh(grid, number, plane, normal, cut, mesh).add(); },
	                  block.grid);
}

} // namespace vp::slice
