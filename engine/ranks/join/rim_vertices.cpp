#include "ranks/join/rim_vertices.h"

#include "base/place_key.h"
#include "mesh/open_vertices.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace vp::ranks
{

namespace
{

bool isInAny(const Vec3& place, std::span<const Box> boxes)
{
	return std::ranges::any_of(
	    boxes, [&](const Box& box)
	    { return glm::all(glm::greaterThanEqual(place, box.lo)) && glm::all(glm::lessThanEqual(place, box.hi)); });
}

/// Returns true if a vertex may touch another part of a curved surface at a grid point of another rank.
bool mayTouch(const mesh::SheetMesh& mesh, std::uint32_t v, std::span<const Box> others)
{
	if (mesh.flat || v >= mesh.edges.size() || (mesh.edges[v].t != 0.0 && mesh.edges[v].t != 1.0))
		return false;
	return isInAny(mesh.positions[v], others);
}

std::vector<std::uint8_t> rimOf(const mesh::SheetMesh& mesh, std::span<const Box> others)
{
	mesh::OpenVertices open(mesh.positions.size());
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		std::uint32_t before = mesh.polygon(p).back();
		for (const std::uint32_t v : mesh.polygon(p))
			open.add(std::exchange(before, v), v);
	}
	std::vector<std::uint8_t> rim(mesh.positions.size());
	for (std::uint32_t v = 0; v < rim.size(); ++v)
		rim[v] = open.isOpen(v) || mayTouch(mesh, v, others);
	return rim;
}

/// Returns true if a vertex lies on a face with these corners: its edge, or the grid point at which it is. Places are
/// compared, since a vertex is named after one edge only, even if several cells with points of their own meet there.
bool liesOn(const grid::BlockSet& blocks, const mesh::EdgePoint& vertex, std::span<const Vec3> corners)
{
	return std::visit(
	    [&](const auto& grid)
	    {
		    const auto has = [&](PointId p) { return std::ranges::find(corners, grid.point(p)) != corners.end(); };
		    return (vertex.t == 1.0 || has(vertex.lower)) && (vertex.t == 0.0 || has(vertex.higher));
	    },
	    blocks.blocks[vertex.block].grid);
}

/// The grid point at which a vertex lies; none for others.
std::optional<PointId> gridPoint(const mesh::EdgePoint& vertex)
{
	if (vertex.t == 0.0)
		return vertex.lower;
	return vertex.t == 1.0 ? std::optional(vertex.higher) : std::nullopt;
}

/// The cut cells without a polygon, which the sheet meets in a point or a line.
std::vector<mesh::BlockCell> cellsWithoutPolygon(const grid::BlockSet& blocks, std::span<const find::BlockCut> cuts,
                                                 const mesh::SheetMesh& mesh)
{
	const auto keyOf = [](std::uint32_t block, CellId cell) { return std::uint64_t(block) << 32 | cell; };
	std::unordered_set<std::uint64_t> shown;
	for (const auto& [block, cell] : mesh.polygon_cells)
		shown.insert(keyOf(block, cell));
	std::size_t all = 0;
	for (const find::BlockCut& cut : cuts)
		all += cut.cutCells();
	std::vector<mesh::BlockCell> cells;
	if (all == shown.size()) // as nearly always
		return cells;
	for (std::uint32_t b = 0; b < cuts.size(); ++b)
		find::forEachCutCell(blocks.blocks[b], cuts[b],
		                     [&](CellId cell)
		                     {
			                     if (!shown.contains(keyOf(b, cell)))
				                     cells.push_back({b, cell});
		                     });
	return cells;
}

/// Visits the points of a cell: visit(point, place), some of them several times.
template <class Visit>
void forCorners(const grid::BlockSet& blocks, const mesh::BlockCell& cell, const Visit& visit)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces faces;
		    grid.cellFaces(cell.cell, faces);
		    for (int f = 0; f < faces.size(); ++f)
			    for (const PointId p : faces[f])
				    visit(p, grid.point(p));
	    },
	    blocks.blocks[cell.block].grid);
}

/// Visits the cells that have rim vertices at their points: visit(block, cell, vertices).
template <class Visit>
void forCellsAtRim(const grid::BlockSet& blocks, std::span<const mesh::BlockCell> cells, const mesh::SheetMesh& mesh,
                   const std::vector<std::uint8_t>& rim, const Visit& visit)
{
	if (cells.empty())
		return;
	std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> at_place;
	const auto pointOf = [&](std::uint32_t block, PointId p)
	{ return std::visit([&](const auto& grid) { return grid.point(p); }, blocks.blocks[block].grid); };
	for (std::uint32_t v = 0; v < mesh.edges.size(); ++v)
		if (const auto p = gridPoint(mesh.edges[v]); rim[v] && p)
			at_place[placeKey(pointOf(mesh.edges[v].block, *p))].push_back(v);
	std::vector<std::uint32_t> vertices;
	for (const auto& [block, cell] : cells)
	{
		vertices.clear();
		forCorners(blocks, {block, cell},
		           [&](PointId, const Vec3& place)
		           {
			           if (const auto at = at_place.find(placeKey(place)); at != at_place.end())
				           vertices.insert(vertices.end(), at->second.begin(), at->second.end());
		           });
		std::ranges::sort(vertices);
		vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
		if (!vertices.empty())
			visit(block, cell, vertices);
	}
}

/// The faces of cells on which the vertices of the rim lie; of others none. bare: cells without a polygon.
std::vector<std::vector<FaceKey>> facesAtRim(const grid::BlockSet& blocks, std::span<const mesh::BlockCell> bare,
                                             const mesh::SheetMesh& mesh, const std::vector<std::uint8_t>& rim)
{
	std::vector<std::vector<FaceKey>> of_vertex(rim.size());
	grid::CellFaces faces;
	std::vector<Vec3> corners;
	const auto takesPart = [&](std::uint32_t v) { return rim[v] && v < mesh.edges.size(); };
	const auto addCell = [&](std::uint32_t block, CellId cell, std::span<const std::uint32_t> vertices)
	{
		std::visit(
		    [&](const auto& grid)
		    {
			    grid.cellFaces(cell, faces);
			    for (int f = 0; f < faces.size(); ++f)
			    {
				    FaceKey key;
				    corners.clear();
				    for (const PointId point : faces[f])
					    corners.push_back(grid.point(point));
				    for (const Vec3& corner : corners)
					    addCorner(corner, key);
				    for (const std::uint32_t v : vertices)
					    if (takesPart(v) && liesOn(blocks, mesh.edges[v], corners))
						    of_vertex[v].push_back(key);
			    }
		    },
		    blocks.blocks[block].grid);
	};
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		if (std::ranges::any_of(mesh.polygon(p), takesPart))
			addCell(mesh.polygon_cells[p].block, mesh.polygon_cells[p].cell, mesh.polygon(p));
	forCellsAtRim(blocks, bare, mesh, rim, addCell);
	for (std::vector<FaceKey>& keys : of_vertex)
	{
		std::ranges::sort(keys);
		keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
	}
	return of_vertex;
}

/// Adds vertices that are not in the mesh, at points of cells without a polygon that other ranks may have as well.
void addBesideMesh(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                   std::span<const mesh::BlockCell> bare, std::span<const Box> others, std::vector<RimVertex>& vertices)
{
	std::unordered_set<std::uint64_t> known;
	for (const RimVertex& vertex : vertices)
		known.insert(placeKey(vertex.place));
	std::map<std::pair<std::uint32_t, PointId>, RimVertex> added;
	grid::CellFaces faces;
	const auto addFace = [&](const auto& grid, std::uint32_t block, int f)
	{
		FaceKey key;
		for (const PointId p : faces[f])
			addCorner(grid.point(p), key);
		for (int i = 0; i < static_cast<int>(faces[f].size()); ++i)
		{
			const PointId p = faces[f][static_cast<std::size_t>(i)];
			const PointId next = faces[f][static_cast<std::size_t>(i + 1) % faces[f].size()];
			const Vec3 place = grid.point(p) + 0.0; // no -0
			if (!isInAny(place, others) || known.contains(placeKey(place)))
				continue;
			const auto [at, is_new] = added.try_emplace({block, p});
			if (is_new)
			{
				at->second = vertexOn(blocks, whole, {block, p, next, 0.0});
				at->second.vertex = RimVertex::kNone;
				at->second.place = place;
			}
			at->second.faces.push_back(key);
		}
	};
	for (const auto& [block, cell] : bare)
		std::visit(
		    [&, b = block, c = cell](const auto& grid)
		    {
			    grid.cellFaces(c, faces);
			    for (int f = 0; f < faces.size(); ++f)
				    addFace(grid, b, f);
		    },
		    blocks.blocks[block].grid);
	for (auto& [point, vertex] : added)
	{
		std::ranges::sort(vertex.faces);
		vertices.push_back(std::move(vertex));
	}
}

} // namespace

std::vector<RimVertex> rimVertices(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                                   std::span<const find::BlockCut> cuts, std::span<const std::uint32_t> components,
                                   std::span<const Box> others, const mesh::SheetMesh& mesh)
{
	const std::vector<std::uint8_t> rim = rimOf(mesh, others);
	const std::vector<mesh::BlockCell> bare = cellsWithoutPolygon(blocks, cuts, mesh);
	std::vector<std::vector<FaceKey>> faces = facesAtRim(blocks, bare, mesh, rim);
	std::vector<RimVertex> vertices;
	for (std::uint32_t v = 0; v < rim.size(); ++v)
	{
		if (!rim[v])
			continue;
		const bool on_edge = v < mesh.edges.size();
		RimVertex& vertex = vertices.emplace_back();
		if (on_edge)
			vertex = vertexOn(blocks, whole, mesh.edges[v]);
		else
		{
			const std::uint32_t block = mesh.rimShares(v)[0].block;
			vertex.whole = whole[block];
			vertex.of_lattice = !std::holds_alternative<grid::UnstructuredGrid>(blocks.blocks[block].grid);
			vertex.of_pack = blocks.blocks[block].runs && blocks.blocks[block].runs->isShare();
		}
		vertex.on_edge = on_edge;
		vertex.vertex = v;
		vertex.place = mesh.positions[v] + 0.0; // no -0
		vertex.component = components[v];
		vertex.faces = std::move(faces[v]);
	}
	addBesideMesh(blocks, whole, bare, others, vertices);
	return vertices;
}

} // namespace vp::ranks
