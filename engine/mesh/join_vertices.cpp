#include "mesh/join_vertices.h"

#include "base/key_numbers.h"
#include "base/place_key.h"
#include "base/union_find.h"
#include "mesh/mesh_seams.h"
#include "mesh/seam_values.h"
#include "mesh/seam_vertices.h"

#include <algorithm>
#include <utility>

namespace vp::mesh
{

namespace
{

class VertexJoiner
{
public:
	VertexJoiner(const grid::BlockSet& blocks, SheetMesh& mesh)
	    : blocks_(blocks), mesh_(mesh), joined_(mesh.positions.size()), values_(blocks, mesh)
	{
	}

	bool joinSheet(Hanging hanging)
	{
		joinAtGridPoints();
		return grid::knowsSeams(blocks_) ? join(blocks_.interfaces, false, hanging)
		                                 : join(seamsOfMesh(blocks_, mesh_, joined_), false, hanging);
	}

	void joinFaces(const grid::Interfaces& seams)
	{
		joinAtGridPoints();
		join(seams, true, Hanging::keep);
	}

private:
	bool join(const grid::Interfaces& seams, bool by_place, Hanging hanging)
	{
		std::vector<HangingVertex> hanging_vertices = joinAtSeams(seams, by_place, hanging);
		const bool meets_itself = !mesh_.edges.empty() && seams.of(mesh_.edges[0].block) != nullptr;
		if (ofSeveralBlocks() || (by_place && meets_itself))
			joinAtSamePlace(by_place);
		const bool hangs = !hanging_vertices.empty();
		if (hangs)
			linkHanging(hanging_vertices, hanging, values_, joined_, mesh_);
		const bool any = joined_.count() < joined_.size();
		if (any)
			nameAfterRoots();
		if (hangs && hanging == Hanging::interpolate)
			interpolateHanging(blocks_, hanging_vertices, joined_, mesh_);
		return any || hangs || !mesh_.seam_pairs.empty();
	}

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

	// Returns the vertices that hang and are left to link.
	std::vector<HangingVertex> joinAtSeams(const grid::Interfaces& seams, bool by_place, Hanging hanging)
	{
		SeamVertices found = seamVertices(blocks_, seams, mesh_);
		for (const VertexPair& pair : found.pairs)
			if (!by_place || areOnEdge(pair.first, pair.second))
				joinOrPair(pair.first, pair.second);
		if (by_place)
			return {};
		const bool keeps = hanging == Hanging::keep;
		std::vector<HangingVertex> left;
		for (const HangingVertex& h : found.hanging)
		{
			const std::uint32_t end = h.at < 0.5 ? h.from : h.to;
			if (h.isAtEnd() && (keeps || !areOnePlace(h.vertex, end)))
				joinOrPair(h.vertex, end);
			else if (keeps || values_.haveSameArrays(h.vertex, end))
				left.push_back(h);
			else
				mesh_.seam_pairs.emplace_back(h.vertex, end);
		}
		for (const HangingVertex& h : left)
			if (h.isAtEnd())
				joined_.join(h.vertex, h.end());
		return left;
	}

	// Joins vertices that lie on each other, if neither a value nor a place changes by that.
	void joinOrPair(std::uint32_t v, std::uint32_t w)
	{
		if (joined_.root(v) == joined_.root(w))
			return;
		if (areOnePlace(v, w) && values_.agree(v, w))
			joined_.join(v, w);
		else
			mesh_.seam_pairs.emplace_back(v, w);
	}

	void nameAfterRoots()
	{
		const auto rename = [&](std::uint32_t& v)
		{
			if (v < joined_.size())
				v = joined_.root(v);
		};
		std::ranges::for_each(mesh_.polygon_vertices, rename);
		for (auto& [v, w] : mesh_.seam_pairs)
		{
			rename(v);
			rename(w);
		}
		std::erase_if(mesh_.seam_pairs, [](const VertexPair& pair) { return pair.first == pair.second; });
	}

	bool ofSeveralBlocks() const
	{
		return std::ranges::any_of(mesh_.edges, [&](const EdgePoint& e) { return e.block != mesh_.edges[0].block; });
	}

	// Two corners of one polygon at one place, as beside a grid point, stay two: its mean depends on that. So of each
	// block a place has one vertex, except by place.
	void joinAtSamePlace(bool by_place)
	{
		struct Place
		{
			std::uint32_t vertex;
			std::uint32_t last_block;
		};
		KeyNumbers at_place(mesh_.positions.size());
		std::vector<Place> places;
		for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v)
		{
			const std::uint32_t block = mesh_.edges[v].block;
			const auto [number, is_new] =
			    at_place.find(placeKey(mesh_.positions[v]), static_cast<std::uint32_t>(places.size()));
			if (is_new)
			{
				places.push_back({v, block});
				continue;
			}
			Place& first = places[number];
			if (mesh_.positions[first.vertex] == mesh_.positions[v] && (by_place || block != first.last_block) &&
			    values_.agree(first.vertex, v))
			{
				joined_.join(first.vertex, v);
				first.last_block = block;
			}
		}
	}

	double edgeLength(std::uint32_t v) const
	{
		const EdgePoint& edge = mesh_.edges[v];
		return std::visit([&](const auto& grid)
		                  { return glm::length(grid.point(edge.higher) - grid.point(edge.lower)); },
		                  blocks_.blocks[edge.block].grid);
	}

	bool areOnePlace(std::uint32_t v, std::uint32_t w) const
	{
		return isOnePlace(mesh_.positions[v], mesh_.positions[w], edgeLength(v));
	}

	// As seen from the length of the edge; its ends are the same points within a far smaller tolerance.
	bool areOnEdge(std::uint32_t v, std::uint32_t w) const
	{
		constexpr double kApart = 1e-4;
		const EdgePoint& edge = mesh_.edges[v];
		return edge.t == 0.0 || edge.t == 1.0 ||
		       glm::length(mesh_.positions[v] - mesh_.positions[w]) <= kApart * edgeLength(v);
	}

	const grid::BlockSet& blocks_;
	SheetMesh& mesh_;
	UnionFind joined_;
	SeamValues values_;
};

} // namespace

bool joinVertices(const grid::BlockSet& blocks, SheetMesh& mesh, Hanging hanging)
{
	return VertexJoiner(blocks, mesh).joinSheet(hanging);
}

void joinVerticesOfFaces(const grid::BlockSet& blocks, const grid::Interfaces& seams, SheetMesh& mesh)
{
	VertexJoiner(blocks, mesh).joinFaces(seams);
}

} // namespace vp::mesh
