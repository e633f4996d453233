#include "all_pieces.h"

#include "base/union_find.h"
#include "exhaustive.h"
#include "find/cell_signs.h"
#include "find/curved_sheet.h"
#include "mesh/build_mesh.h"
#include "mesh/sheet_mesh.h"

#include <algorithm>
#include <map>

namespace vp::test
{

namespace
{

using Polygon = std::vector<Vec3>; // in the box's coordinates

Polygon clipped(Polygon polygon, const contour::ClipBox& box)
{
	for (int axis = 0; axis < 3; ++axis)
		for (const double sense : {1.0, -1.0})
		{
			const double bound = sense > 0.0 ? box.lo()[axis] : box.hi()[axis];
			const auto within = [&](const Vec3& p) { return sense * (p[axis] - bound); };
			Polygon kept;
			for (std::size_t i = 0; i < polygon.size(); ++i)
			{
				const Vec3& a = polygon[i];
				const Vec3& b = polygon[(i + 1) % polygon.size()];
				if (within(a) >= 0.0)
					kept.push_back(a);
				if (within(a) * within(b) < 0.0)
					kept.push_back(a + within(a) / (within(a) - within(b)) * (b - a));
			}
			polygon = std::move(kept);
		}
	return polygon;
}

double areaOf(const Polygon& polygon)
{
	Vec3 center(0.0);
	Vec3 whole(0.0);
	for (const Vec3& p : polygon)
		center += p / double(polygon.size());
	const auto cross = [&](std::size_t i)
	{ return glm::cross(polygon[i] - center, polygon[(i + 1) % polygon.size()] - center); };
	for (std::size_t i = 0; i < polygon.size(); ++i)
		whole += cross(i);
	double area = 0.0;
	for (std::size_t i = 0; i < polygon.size(); ++i)
		area += 0.5 * std::copysign(glm::length(cross(i)), glm::dot(cross(i), whole));
	return area;
}

template <class G>
find::CellCut scan(const G& grid, const surface::BlockSurface& surface)
{
	find::CellCut cut;
	grid::CellFaces faces;
	for (CellId c = 0; c < grid.cellCount(); ++c)
	{
		const grid::CellShape shape = grid.shape(c);
		std::uint32_t code =
		    shape == grid::CellShape::polyhedron ? shared::kCodeWalk : find::classifyByTable(grid, surface, c, shape);
		if (code & shared::kCodeWalk)
			code = find::classifyByWalk(grid, surface, c, faces);
		if (!(code & shared::kCodeCut))
			continue;
		cut.cells.push_back(c);
		cut.codes.push_back(code);
	}
	cut.cut_cells = cut.cells.size();
	return cut;
}

// Polygons that share a side which reaches into the box, or a vertex in it.
void joinNeighbors(const mesh::SheetMesh& mesh, const contour::ClipBox& box, UnionFind& polygons)
{
	std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
	const auto join = [&](std::uint32_t v, std::uint32_t w, std::uint32_t p)
	{
		const auto [known, is_new] = first.emplace(std::minmax(v, w), p);
		if (!is_new)
			polygons.join(known->second, p);
	};
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto corners = mesh.polygon(p);
		for (std::size_t i = 0; i < corners.size(); ++i)
		{
			const std::uint32_t v = corners[i];
			const std::uint32_t w = corners[(i + 1) % corners.size()];
			if (seed::reachesInto(box.inBox(mesh.positions[v]), box.inBox(mesh.positions[w]), box.lo(), box.hi()))
				join(v, w, p);
			if (seed::reachesInto(box.inBox(mesh.positions[v]), box.inBox(mesh.positions[v]), box.lo(), box.hi()))
				join(v, v, p);
		}
	}
}

} // namespace

PiecesOnSheet piecesOnSheet(const grid::BlockSet& set, const std::string& field, double value,
                            const contour::ClipBox& box)
{
	const auto surfaces = find::isoSurfaces(set, value, grid::FieldChoice{field, grid::Association::point, 0});
	std::vector<find::CellCut> cuts;
	for (std::size_t b = 0; b < set.blocks.size(); ++b)
		cuts.push_back(visitGrid(set.blocks[b], [&](const auto& grid) { return scan(grid, surfaces[b]); }));
	std::vector<mesh::ShownBlock> of_blocks;
	PiecesOnSheet found;
	for (std::size_t b = 0; b < cuts.size(); ++b)
	{
		of_blocks.push_back({std::uint32_t(b), &cuts[b]});
		found.cut_cells += cuts[b].cut_cells;
	}
	const mesh::SheetMesh mesh = mesh::buildMesh(set, surfaces, of_blocks);
	UnionFind joined(mesh.polygons());
	joinNeighbors(mesh, box, joined);

	std::vector<Polygon> parts(mesh.polygons());
	std::map<std::uint32_t, Box> pieces;
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		for (const std::uint32_t v : mesh.polygon(p))
			parts[p].push_back(box.inBox(mesh.positions[v]));
		parts[p] = clipped(parts[p], box);
		for (const Vec3& corner : parts[p])
			pieces[joined.root(p)].include(corner);
	}
	const auto touches = [&](const Box& piece) { return piece.lo.z <= 0.0 && piece.hi.z >= 0.0; };
	for (const auto& [root, piece] : pieces)
		found.pieces += touches(piece);
	for (std::uint32_t p = 0; p < mesh.polygons(); ++p)
	{
		if (parts[p].size() < 3 || !touches(pieces[joined.root(p)]))
			continue;
		found.area += areaOf(parts[p]);
		++found.polygons;
		found.cells.emplace(mesh.polygon_cells[p].block, mesh.polygon_cells[p].cell);
	}
	return found;
}

} // namespace vp::test
