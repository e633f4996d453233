#include "mesh/hanging_vertices.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace vp::mesh
{

namespace
{

class Linker
{
public:
	Linker(const grid::BlockSet& blocks, Hanging hanging, UnionFind& joined, SheetMesh& mesh)
	    : blocks_(blocks), hanging_(hanging), joined_(joined), mesh_(mesh)
	{
	}

	void link(std::span<const HangingVertex> vertices)
	{
		chooseNames(vertices);
		insert(vertices);
		if (hanging_ == Hanging::interpolate)
			interpolate(vertices);
	}

private:
	double edgeLength(const EdgePoint& edge) const
	{
		return std::visit([&](const auto& grid)
		                  { return glm::length(grid.point(edge.higher) - grid.point(edge.lower)); },
		                  blocks_.blocks[edge.block].grid);
	}

	// Of the edges on which a joined vertex lies, it is named after the longest or the shortest one.
	void chooseNames(std::span<const HangingVertex> vertices)
	{
		std::unordered_map<std::uint32_t, std::uint32_t> chosen; // by what stands for the vertex
		const auto offer = [&](std::uint32_t v)
		{
			std::uint32_t& best = chosen.try_emplace(joined_.root(v), v).first->second;
			const double length = edgeLength(mesh_.edges[v]);
			const double known = edgeLength(mesh_.edges[best]);
			if (hanging_ == Hanging::interpolate ? length > known : length < known)
				best = v;
		};
		for (const HangingVertex& h : vertices)
			if (h.isAtEnd())
			{
				offer(h.vertex);
				offer(h.end());
			}
		std::vector<std::tuple<std::uint32_t, EdgePoint, Vec3>> names;
		for (const auto& [root, best] : chosen)
			names.emplace_back(root, mesh_.edges[best], mesh_.positions[best]);
		for (const auto& [root, edge, place] : names)
		{
			mesh_.edges[root] = edge;
			mesh_.positions[root] = place;
		}
	}

	void insert(std::span<const HangingVertex> vertices)
	{
		std::vector<HangingVertex> inner;
		for (HangingVertex h : vertices)
		{
			h.vertex = joined_.root(h.vertex);
			h.from = joined_.root(h.from);
			h.to = joined_.root(h.to);
			if (!h.isAtEnd() && h.vertex != h.from && h.vertex != h.to)
				inner.push_back(h);
		}
		std::ranges::sort(inner, [](const HangingVertex& a, const HangingVertex& b)
		                  { return std::tie(a.polygon, a.from, a.at) < std::tie(b.polygon, b.from, b.at); });
		RawVector<std::uint32_t> starts{0};
		RawVector<std::uint32_t> corners;
		starts.reserve(mesh_.polygon_starts.size());
		corners.reserve(mesh_.polygon_vertices.size() + inner.size());
		auto next = inner.begin();
		for (std::size_t p = 0; p < mesh_.polygons(); ++p)
		{
			auto end = next;
			while (end != inner.end() && end->polygon == p)
				++end;
			const std::span<const std::uint32_t> polygon = mesh_.polygon(p);
			for (std::size_t i = 0; i < polygon.size(); ++i)
			{
				corners.push_back(polygon[i]);
				const std::uint32_t to = polygon[(i + 1) % polygon.size()];
				for (auto h = next; h != end; ++h)
					if (h->from == polygon[i] && h->to == to && corners.back() != h->vertex)
						corners.push_back(h->vertex);
			}
			next = end;
			starts.push_back(static_cast<std::uint32_t>(corners.size()));
		}
		mesh_.polygon_starts = std::move(starts);
		mesh_.polygon_vertices = std::move(corners);
	}

	// Hanging vertices become weighted means of the ends of the longest edge on which they hang, as those on the rim of
	// a window are. The ends may hang on edges of still larger cells.
	void interpolate(std::span<const HangingVertex> vertices)
	{
		for (const HangingVertex& h : vertices)
		{
			const std::uint32_t vertex = joined_.root(h.vertex);
			const HangingVertex rooted{vertex, h.polygon, joined_.root(h.from), joined_.root(h.to), h.at};
			if (h.isAtEnd() || vertex == rooted.from || vertex == rooted.to)
				continue;
			const auto [known, is_new] = hung_.try_emplace(vertex, rooted);
			if (!is_new && span(rooted) > span(known->second))
				known->second = rooted;
		}
		std::vector<std::uint32_t> order;
		for (const auto& [vertex, h] : hung_)
			order.push_back(vertex);
		std::ranges::sort(order);
		std::unordered_map<std::uint32_t, std::uint32_t> renamed;
		for (const std::uint32_t vertex : order)
		{
			renamed.emplace(vertex, static_cast<std::uint32_t>(mesh_.positions.size()));
			mesh_.positions.push_back(Vec3(mesh_.positions[vertex]));
			addShares(vertex, 1.0, kMaxLevels);
			mesh_.rim_starts.push_back(static_cast<std::uint32_t>(mesh_.rim_shares.size()));
		}
		for (std::uint32_t& corner : mesh_.polygon_vertices)
			if (const auto found = renamed.find(corner); found != renamed.end())
				corner = found->second;
		for (auto& [v, w] : mesh_.seam_pairs)
			for (std::uint32_t* of : {&v, &w})
				if (const auto found = renamed.find(joined_.root(*of)); found != renamed.end())
					*of = found->second;
	}

	double span(const HangingVertex& h) const { return glm::length(mesh_.positions[h.to] - mesh_.positions[h.from]); }

	void addShares(std::uint32_t v, double weight, int levels)
	{
		const auto hung = hung_.find(v);
		if (hung == hung_.end() || levels == 0)
			return vp::mesh::addShares(mesh_, v, weight, mesh_.rim_shares);
		addShares(hung->second.from, weight * (1.0 - hung->second.at), levels - 1);
		addShares(hung->second.to, weight * hung->second.at, levels - 1);
	}

	static constexpr int kMaxLevels = 8; // each makes two of one

	const grid::BlockSet& blocks_;
	Hanging hanging_;
	UnionFind& joined_;
	SheetMesh& mesh_;
	std::unordered_map<std::uint32_t, HangingVertex> hung_;
};

} // namespace

void linkHanging(const grid::BlockSet& blocks, std::span<const HangingVertex> vertices, Hanging hanging,
                 UnionFind& joined, SheetMesh& mesh)
{
	if (!vertices.empty())
		Linker(blocks, hanging, joined, mesh).link(vertices);
}

} // namespace vp::mesh
