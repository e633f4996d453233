#include "ranks/join/rim_vertex.h"

#include "base/place_key.h"
#include "mesh/mesh_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

bool RimVertex::hasSamePoints(const RimVertex& other) const
{
	const bool may_have = (of_lattice && other.of_lattice) || (of_pack && other.of_pack && points == other.points);
	return may_have && whole == other.whole && isOnSameEdge(other);
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

RimVertex vertexOn(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, const mesh::EdgePoint& at)
{
	const grid::Block& block = blocks.blocks[at.block];
	RimVertex vertex;
	vertex.whole = whole[at.block];
	vertex.of_lattice = !std::holds_alternative<grid::UnstructuredGrid>(block.grid);
	vertex.of_pack = block.runs && block.runs->isShare();
	vertex.points = {at.lower, at.higher};
	vertex.near = nearOf(block, at);
	vertex.ends = endsOf(block, at);
	vertex.edge_length = lengthOf(block, at);
	vertex.arrays = valuesAt(block, at);
	return vertex;
}

RimVertex gridVertex(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, const mesh::SheetMesh& mesh,
                     std::uint32_t vertex)
{
	RimVertex made = vertexOn(blocks, whole, mesh.edges[vertex]);
	made.vertex = vertex;
	made.place = mesh.positions[vertex] + 0.0; // no -0
	made.near = 0.0;
	made.of_lattice = true; // whose pieces share points
	made.ends = {made.place, made.place};
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
	to.put(vertex.of_pack);
	to.put(vertex.points);
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
	vertex.of_pack = from.get<bool>();
	vertex.points = from.get<std::array<PointId, 2>>();
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
