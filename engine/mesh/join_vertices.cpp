#include "mesh/join_vertices.h"

#include "base/key_numbers.h"
#include "base/place_key.h"
#include "mesh/mesh_seams.h"
#include "mesh/mesh_values.h"
#include "mesh/seam_vertices.h"
#include "mesh/union_find.h"

#include <algorithm>
#include <cmath>

namespace vp::mesh
{

namespace
{

// Wide integers are taken for ids: the copies of a point have ids of their own and are one point for all that.
bool isId(const grid::Field& field)
{
	using enum grid::NumberType;
	return field.type == int32 || field.type == uint32 || field.type == int64 || field.type == uint64;
}

bool isPointField(const grid::Field& field)
{
	return field.association == grid::Association::point;
}

class VertexJoiner
{
public:
	VertexJoiner(const grid::BlockSet& blocks, SheetMesh& mesh)
	    : blocks_(blocks), mesh_(mesh), joined_(mesh.positions.size())
	{
	}

	bool join(bool by_place, Hanging hanging)
	{
		joinAtGridPoints();
		joinAtSeams(by_place);
		if (ofSeveralBlocks() || (by_place && meetsItself()))
			joinAtSamePlace();
		const bool any = joined_.count() < mesh_.positions.size();
		if (any)
			for (std::uint32_t& v : mesh_.polygon_vertices)
				v = joined_.root(v);
		linkHanging(blocks_, hanging_, hanging, joined_, mesh_);
		return any || !hanging_.empty() || !mesh_.seam_pairs.empty();
	}

private:
	void joinAtGridPoints()
	{
		KeyNumbers at_point(0);
		std::vector<std::uint32_t> first;
		for (std::uint32_t v = 0; v < mesh_.edges.size(); ++v)
		{
			const EdgePoint& edge = mesh_.edges[v];
			if (edge.t != 0.0 && edge.t != 1.0)
				continue;
			const PointId point = edge.t == 0.0 ? edge.lower : edge.higher;
			const auto [number, is_new] =
			    at_point.find(std::uint64_t(edge.block) << 32 | point, static_cast<std::uint32_t>(first.size()));
			if (is_new)
				first.push_back(v);
			else
				joined_.join(first[number], v);
		}
	}

	void joinAtSeams(bool by_place)
	{
		const SeamVertices found = grid::knowsSeams(blocks_)
		                               ? seamVertices(blocks_, blocks_.interfaces, mesh_)
		                               : seamVertices(blocks_, seamsOfMesh(blocks_, mesh_, joined_), mesh_);
		for (const VertexPair& pair : found.pairs)
			if (by_place && !areOnePlace(pair.first, pair.second))
				continue;
			else if (haveSameData(pair.first, pair.second))
				joined_.join(pair.first, pair.second);
			else
				mesh_.seam_pairs.push_back(pair);
		if (by_place)
			return;
		for (const HangingVertex& h : found.hanging)
			if (!haveSameArrays(h.vertex, h.from))
				mesh_.seam_pairs.emplace_back(h.vertex, h.at < 0.5 ? h.from : h.to);
			else
			{
				hanging_.push_back(h);
				if (h.isAtEnd())
					joined_.join(h.vertex, h.end());
			}
	}

	bool ofSeveralBlocks() const
	{
		return std::ranges::any_of(mesh_.edges, [&](const EdgePoint& e) { return e.block != mesh_.edges[0].block; });
	}

	bool meetsItself() const
	{
		return !mesh_.edges.empty() &&
		       (!grid::knowsSeams(blocks_) || blocks_.interfaces.of(mesh_.edges[0].block) != nullptr);
	}

	void joinAtSamePlace()
	{
		KeyNumbers at_place(mesh_.positions.size());
		std::vector<std::uint32_t> first;
		for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v)
		{
			const auto [number, is_new] =
			    at_place.find(placeKey(mesh_.positions[v]), static_cast<std::uint32_t>(first.size()));
			if (is_new)
				first.push_back(v);
			else if (mesh_.positions[first[number]] == mesh_.positions[v] && haveSameData(first[number], v))
				joined_.join(first[number], v);
		}
	}

	// As seen from the length of the edge; its ends are the same points within a far smaller tolerance.
	bool areOnePlace(std::uint32_t v, std::uint32_t w) const
	{
		constexpr double kApart = 1e-4;
		const EdgePoint& edge = mesh_.edges[v];
		const double length =
		    std::visit([&](const auto& grid) { return glm::length(grid.point(edge.higher) - grid.point(edge.lower)); },
		               blocks_.blocks[edge.block].grid);
		return edge.t == 0.0 || edge.t == 1.0 ||
		       glm::length(mesh_.positions[v] - mesh_.positions[w]) <= kApart * length;
	}

	bool haveSameData(std::uint32_t v, std::uint32_t w) const
	{
		const std::vector<grid::Field>& fields = blocks_.blocks[mesh_.edges[v].block].fields;
		const std::vector<grid::Field>& others = blocks_.blocks[mesh_.edges[w].block].fields;
		if (std::ranges::count_if(fields, isPointField) != std::ranges::count_if(others, isPointField))
			return false;
		for (const grid::Field& field : fields)
		{
			if (!isPointField(field))
				continue;
			const auto other = std::ranges::find_if(others, [&](const grid::Field& o)
			                                        { return isPointField(o) && o.name == field.name; });
			if (other == others.end() || other->components != field.components)
				return false;
			for (int c = 0; c < field.components && !(isId(field) && isId(*other)); ++c)
				if (!isSame(valueAt(field, c, v), valueAt(*other, c, w), scaleAt(field, c, v)))
					return false;
		}
		return true;
	}

	bool haveSameArrays(std::uint32_t v, std::uint32_t w) const
	{
		const std::vector<grid::Field>& fields = blocks_.blocks[mesh_.edges[v].block].fields;
		const std::vector<grid::Field>& others = blocks_.blocks[mesh_.edges[w].block].fields;
		return std::ranges::count_if(fields, isPointField) == std::ranges::count_if(others, isPointField) &&
		       std::ranges::all_of(fields,
		                           [&](const grid::Field& field)
		                           {
			                           return !isPointField(field) ||
			                                  std::ranges::any_of(others,
			                                                      [&](const grid::Field& o) {
				                                                      return isPointField(o) && o.name == field.name &&
				                                                             o.components == field.components;
			                                                      });
		                           });
	}

	double valueAt(const grid::Field& field, int component, std::uint32_t v) const
	{
		return interpolate(blocks_.blocks[mesh_.edges[v].block], field, component, mesh_.edges[v]);
	}

	// How large the numbers are that a value was interpolated from.
	double scaleAt(const grid::Field& field, int component, std::uint32_t v) const
	{
		EdgePoint end = mesh_.edges[v];
		double scale = 0.0;
		for (const double t : {0.0, 1.0})
		{
			end.t = t;
			scale = std::max(scale, std::abs(interpolate(blocks_.blocks[end.block], field, component, end)));
		}
		return scale;
	}
	// Copies of one number, written in single precision perhaps, and interpolated at places a rounding apart.
	static bool isSame(double a, double b, double scale)
	{
		return std::abs(a - b) <= 1e-5 * scale || (std::isnan(a) && std::isnan(b));
	}

	const grid::BlockSet& blocks_;
	SheetMesh& mesh_;
	UnionFind joined_;
	std::vector<HangingVertex> hanging_;
};

} // namespace

bool joinVertices(const grid::BlockSet& blocks, SheetMesh& mesh, bool by_place, Hanging hanging)
{
	return VertexJoiner(blocks, mesh).join(by_place, hanging);
}

} // namespace vp::mesh
