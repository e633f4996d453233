#include "ranks/join/rim_vertices.h"

#include "base/place_key.h"
#include "mesh/mesh_values.h"
#include "mesh/open_vertices.h"

#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace vp::ranks
{

void addCorner(const Vec3& corner, FaceKey& key)
{
	const std::uint64_t place = placeKey(corner);
	key.sum += place;
	key.mixed ^= (place >> 7) * 0xD1B54A32D192ED03ull;
	++key.corners;
}

bool ValueAt::isSame(const ValueAt& other) const
{
	return mesh::isSameValue(value, other.value, std::max(scale, other.scale));
}

bool RimVertex::isAcross(const RimVertex& other) const
{
	return std::ranges::any_of(faces,
	                           [&](const FaceKey& face) { return std::ranges::binary_search(other.faces, face); });
}

bool RimVertex::isOnSameEdge(const RimVertex& other) const
{
	const double apart = std::min(near, other.near);
	const auto areNear = [&](int end, int other_end)
	{ return glm::length(ends[end] - other.ends[other_end]) <= apart; };
	return (ends[0] == ends[1]) == (other.ends[0] == other.ends[1]) &&
	       ((areNear(0, 0) && areNear(1, 1)) || (areNear(0, 1) && areNear(1, 0)));
}

bool RimVertex::isOneWith(const RimVertex& other) const
{
	return mesh::isOnePlace(place, other.place, edge_length) && hasDataOf(other);
}

bool RimVertex::hasDataOf(const RimVertex& other) const
{
	const auto areSame = [](const auto& a, const auto& b)
	{
		return a.first == b.first &&
		       std::ranges::equal(a.second, b.second, [](const ValueAt& x, const ValueAt& y) { return x.isSame(y); });
	};
	return std::ranges::equal(arrays, other.arrays, areSame);
}

namespace
{

/// Returns true if a vertex may touch another part of a curved surface at a grid point of another rank.
bool mayTouch(const mesh::SheetMesh& mesh, std::uint32_t v, std::span<const Box> others)
{
	if (mesh.flat || v >= mesh.edges.size() || (mesh.edges[v].t != 0.0 && mesh.edges[v].t != 1.0))
		return false;
	const Vec3& place = mesh.positions[v];
	return std::ranges::any_of(
	    others, [&](const Box& box)
	    { return glm::all(glm::greaterThanEqual(place, box.lo)) && glm::all(glm::lessThanEqual(place, box.hi)); });
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

/// Visits the cut cells without a polygon that have rim vertices at their points: visit(block, cell, vertices).
template <class Visit>
void forCellsWithoutPolygon(const grid::BlockSet& blocks, std::span<const find::BlockCut> cuts,
                            const mesh::SheetMesh& mesh, const std::vector<std::uint8_t>& rim, const Visit& visit)
{
	std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> at_place;
	const auto pointOf = [&](std::uint32_t block, PointId p)
	{ return std::visit([&](const auto& grid) { return grid.point(p); }, blocks.blocks[block].grid); };
	for (std::uint32_t v = 0; v < mesh.edges.size(); ++v)
		if (const auto p = gridPoint(mesh.edges[v]); rim[v] && p)
			at_place[placeKey(pointOf(mesh.edges[v].block, *p))].push_back(v);
	if (at_place.empty())
		return;
	const auto keyOf = [](std::uint32_t block, CellId cell) { return std::uint64_t(block) << 32 | cell; };
	std::unordered_set<std::uint64_t> shown;
	for (const auto& [block, cell] : mesh.polygon_cells)
		shown.insert(keyOf(block, cell));
	std::vector<std::uint32_t> vertices;
	for (std::uint32_t b = 0; b < cuts.size(); ++b)
		find::forEachCutCell(
		    blocks.blocks[b], cuts[b],
		    [&](CellId cell)
		    {
			    if (shown.contains(keyOf(b, cell)))
				    return;
			    vertices.clear();
			    std::visit(
			        [&](const auto& grid)
			        {
				        grid::CellFaces faces;
				        grid.cellFaces(cell, faces);
				        for (int f = 0; f < faces.size(); ++f)
					        for (const PointId p : faces[f])
						        if (const auto at = at_place.find(placeKey(grid.point(p))); at != at_place.end())
							        vertices.insert(vertices.end(), at->second.begin(), at->second.end());
			        },
			        blocks.blocks[b].grid);
			    std::ranges::sort(vertices);
			    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
			    if (!vertices.empty())
				    visit(b, cell, vertices);
		    });
}

/// The faces of cells on which the vertices of the rim lie; of others none.
std::vector<std::vector<FaceKey>> facesAtRim(const grid::BlockSet& blocks, std::span<const find::BlockCut> cuts,
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
	forCellsWithoutPolygon(blocks, cuts, mesh, rim, addCell);
	for (std::vector<FaceKey>& keys : of_vertex)
	{
		std::ranges::sort(keys);
		keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
	}
	return of_vertex;
}

/// As the faces of two blocks that meet (grid/interfaces.h), seen from the length of the edge.
double nearOf(const grid::Block& block, const mesh::EdgePoint& at)
{
	constexpr double kOfEdge = 1e-6;
	return std::visit(
	    [&](const auto& grid)
	    {
		    double of_place = 4.0 * std::numeric_limits<double>::epsilon();
		    if constexpr (requires { grid.coordinates(); })
			    if (!grid.coordinates().isDouble())
				    of_place = 4.0 * std::numeric_limits<float>::epsilon();
		    const Vec3 a = grid.point(at.lower);
		    const Vec3 b = grid.point(at.higher);
		    const double edge = glm::length(b - a);
		    const double largest = std::max(glm::length(a), glm::length(b));
		    return std::min(std::max(kOfEdge * edge, of_place * largest), 0.01 * edge);
	    },
	    block.grid);
}

double lengthOf(const grid::Block& block, const mesh::EdgePoint& at)
{
	return std::visit([&](const auto& grid) { return glm::length(grid.point(at.higher) - grid.point(at.lower)); },
	                  block.grid);
}

std::array<Vec3, 2> endsOf(const grid::Block& block, const mesh::EdgePoint& at)
{
	return std::visit(
	    [&](const auto& grid) {
		    return std::array{grid.point(at.t == 1.0 ? at.higher : at.lower),
		                      grid.point(at.t == 0.0 ? at.lower : at.higher)};
	    },
	    block.grid);
}

std::vector<std::pair<std::string, std::vector<ValueAt>>> valuesAt(const grid::Block& block, mesh::EdgePoint at)
{
	std::vector<std::pair<std::string, std::vector<ValueAt>>> arrays;
	const double t = at.t;
	for (const grid::Field& field : block.fields)
	{
		if (field.association != grid::Association::point)
			continue;
		std::vector<ValueAt>& values = arrays.emplace_back(field.name, std::vector<ValueAt>()).second;
		for (int c = 0; c < field.components; ++c)
		{
			at.t = t;
			ValueAt value{mesh::interpolate(block, field, c, at), 0.0};
			for (const double end : {0.0, 1.0})
			{
				if (field.categorical) // equal or not
					break;
				at.t = end;
				value.scale = std::max(value.scale, std::abs(mesh::interpolate(block, field, c, at)));
			}
			values.push_back(value);
		}
	}
	std::ranges::sort(arrays, {}, [](const auto& array) -> const std::string& { return array.first; });
	return arrays;
}

} // namespace

std::vector<RimVertex> rimVertices(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                                   std::span<const find::BlockCut> cuts, std::span<const std::uint32_t> components,
                                   std::span<const Box> others, const mesh::SheetMesh& mesh)
{
	const std::vector<std::uint8_t> rim = rimOf(mesh, others);
	std::vector<std::vector<FaceKey>> faces = facesAtRim(blocks, cuts, mesh, rim);
	std::vector<RimVertex> vertices;
	for (std::uint32_t v = 0; v < rim.size(); ++v)
	{
		if (!rim[v])
			continue;
		RimVertex& vertex = vertices.emplace_back();
		vertex.vertex = v;
		vertex.place = mesh.positions[v] + 0.0; // no -0
		vertex.component = components[v];
		vertex.faces = std::move(faces[v]);
		vertex.on_edge = v < mesh.edges.size();
		const std::uint32_t block = vertex.on_edge ? mesh.edges[v].block : mesh.rimShares(v)[0].block;
		vertex.whole = whole[block];
		vertex.of_lattice = !std::holds_alternative<grid::UnstructuredGrid>(blocks.blocks[block].grid);
		if (!vertex.on_edge)
			continue;
		vertex.near = nearOf(blocks.blocks[block], mesh.edges[v]);
		vertex.ends = endsOf(blocks.blocks[block], mesh.edges[v]);
		vertex.edge_length = lengthOf(blocks.blocks[block], mesh.edges[v]);
		vertex.arrays = valuesAt(blocks.blocks[block], mesh.edges[v]);
	}
	return vertices;
}

RimVertex gridVertex(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, const mesh::SheetMesh& mesh,
                     std::uint32_t vertex)
{
	const mesh::EdgePoint& at = mesh.edges[vertex];
	RimVertex made;
	made.vertex = vertex;
	made.place = mesh.positions[vertex] + 0.0; // no -0
	made.whole = whole[at.block];
	made.of_lattice = true; // whose pieces share points
	made.ends = {made.place, made.place};
	made.edge_length = lengthOf(blocks.blocks[at.block], at);
	made.arrays = valuesAt(blocks.blocks[at.block], at);
	return made;
}

void put(MessageWriter& to, const RimVertex& vertex)
{
	to.put(vertex.vertex);
	to.put(vertex.place);
	to.put(vertex.near);
	to.put(vertex.component);
	to.put(vertex.whole);
	to.put(vertex.of_lattice);
	to.put(vertex.on_edge);
	to.put(vertex.ends);
	to.put(vertex.edge_length);
	to.putAll(vertex.faces);
	to.put(vertex.arrays.size());
	for (const auto& [name, values] : vertex.arrays)
	{
		to.put(name);
		to.putAll(values);
	}
}

RimVertex takeVertex(MessageReader& from, int rank)
{
	RimVertex vertex;
	vertex.rank = rank;
	vertex.vertex = from.get<std::uint32_t>();
	vertex.place = from.get<Vec3>();
	vertex.near = from.get<double>();
	vertex.component = from.get<std::uint32_t>();
	vertex.whole = from.get<std::uint32_t>();
	vertex.of_lattice = from.get<bool>();
	vertex.on_edge = from.get<bool>();
	vertex.ends = from.get<std::array<Vec3, 2>>();
	vertex.edge_length = from.get<double>();
	vertex.faces = from.getAll<FaceKey>();
	for (auto left = from.get<std::size_t>(); left > 0; --left)
	{
		std::string name = from.getText();
		vertex.arrays.emplace_back(std::move(name), from.getAll<ValueAt>());
	}
	return vertex;
}

} // namespace vp::ranks
