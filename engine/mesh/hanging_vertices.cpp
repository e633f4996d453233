#include "mesh/hanging_vertices.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace vp::mesh
{

namespace
{

// A corner that a polygon gets on its side from one of its corners to the next. Those of a side come in order.
struct AddedCorner
{
	std::size_t polygon;
	std::uint32_t from;
	std::uint32_t to;
	std::uint32_t corner;
};

void addCorners(std::span<const AddedCorner> added, SheetMesh& mesh)
{
	RawVector<std::uint32_t> starts{0};
	RawVector<std::uint32_t> corners;
	std::vector<std::uint8_t> is_added;
	starts.reserve(mesh.polygon_starts.size());
	corners.reserve(mesh.polygon_vertices.size() + added.size());
	is_added.reserve(mesh.polygon_vertices.size() + added.size());
	const auto add = [&](std::uint32_t corner, bool by_join)
	{
		corners.push_back(corner);
		is_added.push_back(by_join);
	};
	auto next = added.begin();
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		auto end = next;
		while (end != added.end() && end->polygon == p)
			++end;
		const std::span<const std::uint32_t> polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			add(polygon[i], false);
			const std::uint32_t to = polygon[(i + 1) % polygon.size()];
			for (auto h = next; h != end; ++h)
				if (h->from == polygon[i] && h->to == to && corners.back() != h->corner)
					add(h->corner, true);
		}
		next = end;
		starts.push_back(static_cast<std::uint32_t>(corners.size()));
	}
	mesh.polygon_starts = std::move(starts);
	mesh.polygon_vertices = std::move(corners);
	mesh.is_added = std::move(is_added);
}

// The hanging vertices that lie between two corners, in the order of polygons, and along each side.
std::vector<HangingVertex> betweenCorners(std::span<const HangingVertex> vertices, UnionFind& joined)
{
	std::vector<HangingVertex> inner;
	for (const HangingVertex& h : vertices)
		if (const std::uint32_t root = joined.root(h.vertex);
		    !h.isAtEnd() && root != joined.root(h.from) && root != joined.root(h.to))
			inner.push_back(h);
	std::ranges::sort(inner, [](const HangingVertex& a, const HangingVertex& b)
	                  { return std::tie(a.polygon, a.from, a.to, a.at) < std::tie(b.polygon, b.from, b.to, b.at); });
	return inner;
}

// Finds the corners that polygons get.
class CornerFinder
{
public:
	CornerFinder(Hanging hanging, SeamValues& values, UnionFind& joined, SheetMesh& mesh)
	    : hanging_(hanging), values_(values), joined_(joined), mesh_(mesh)
	{
	}

	// Hanging vertices of several cells at one place need one corner.
	std::vector<AddedCorner> corners(std::span<const HangingVertex> sorted)
	{
		std::vector<AddedCorner> added;
		for (std::size_t first = 0, last = 0; first < sorted.size(); first = last)
		{
			while (last < sorted.size() && isSamePlace(sorted[first], sorted[last]))
				++last;
			const HangingVertex& h = sorted[first];
			added.push_back({h.polygon, h.from, h.to, cornerOf(sorted.subspan(first, last - first))});
		}
		return added;
	}

private:
	double lengthOf(const HangingVertex& h) const
	{
		return glm::length(mesh_.positions[h.to] - mesh_.positions[h.from]);
	}
	bool isSamePlace(const HangingVertex& a, const HangingVertex& b) const
	{
		return a.polygon == b.polygon && a.from == b.from && a.to == b.to &&
		       isOnePlace(mesh_.positions[a.vertex], mesh_.positions[b.vertex], lengthOf(a));
	}

	std::uint32_t cornerOf(std::span<const HangingVertex> here)
	{
		const std::uint32_t made = addOnSide(here[0]);
		std::uint32_t corner = made;
		for (const HangingVertex& h : here)
			if (isOnePlace(mesh_.positions[h.vertex], mesh_.positions[made], lengthOf(h)) &&
			    (hanging_ == Hanging::interpolate || values_.agree(h.vertex, made)))
			{
				if (corner == made)
					corner = h.vertex;
				else
					joined_.join(corner, h.vertex);
			}
		for (const HangingVertex& h : here)
			if (corner == made || joined_.root(h.vertex) != joined_.root(corner))
				mesh_.seam_pairs.emplace_back(h.vertex, corner);
		if (corner != made)
			dropLast();
		return corner;
	}

	// A vertex with the values that the larger cell has there.
	std::uint32_t addOnSide(const HangingVertex& h)
	{
		const Vec3 from = mesh_.positions[h.from];
		mesh_.positions.push_back(from + h.at * (mesh_.positions[h.to] - from));
		addShares(mesh_, h.from, 1.0 - h.at, mesh_.rim_shares);
		addShares(mesh_, h.to, h.at, mesh_.rim_shares);
		mesh_.rim_starts.push_back(static_cast<std::uint32_t>(mesh_.rim_shares.size()));
		return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
	}
	void dropLast()
	{
		mesh_.positions.pop_back();
		mesh_.rim_starts.pop_back();
		mesh_.rim_shares.resize(mesh_.rim_starts.back());
	}

	Hanging hanging_;
	SeamValues& values_;
	UnionFind& joined_;
	SheetMesh& mesh_;
};

// Gives joined and hanging vertices the values of the larger cells.
class Interpolator
{
public:
	Interpolator(const grid::BlockSet& blocks, UnionFind& joined, SheetMesh& mesh)
	    : blocks_(blocks), joined_(joined), mesh_(mesh)
	{
	}

	void interpolate(std::span<const HangingVertex> vertices)
	{
		chooseNames(vertices);
		makeMeans(vertices);
	}

private:
	double edgeLength(const EdgePoint& edge) const
	{
		return std::visit([&](const auto& grid)
		                  { return glm::length(grid.point(edge.higher) - grid.point(edge.lower)); },
		                  blocks_.blocks[edge.block].grid);
	}

	// Names each joined vertex after the longest of the edges on which it lies.
	void chooseNames(std::span<const HangingVertex> vertices)
	{
		std::unordered_map<std::uint32_t, std::uint32_t> chosen; // by the vertex that represents it
		const auto offer = [&](std::uint32_t v)
		{
			std::uint32_t& best = chosen.try_emplace(joined_.root(v), v).first->second;
			if (edgeLength(mesh_.edges[v]) > edgeLength(mesh_.edges[best]))
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

	// Hanging vertices become weighted means of the ends of the longest edge on which they hang, as those on the rim of
	// a window are. The ends may hang on edges of still larger cells.
	void makeMeans(std::span<const HangingVertex> vertices)
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
				if (const auto found = renamed.find(*of); found != renamed.end())
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
	UnionFind& joined_;
	SheetMesh& mesh_;
	std::unordered_map<std::uint32_t, HangingVertex> hung_;
};

} // namespace

void linkHanging(std::span<const HangingVertex> vertices, Hanging hanging, SeamValues& values, UnionFind& joined,
                 SheetMesh& mesh)
{
	addCorners(CornerFinder(hanging, values, joined, mesh).corners(betweenCorners(vertices, joined)), mesh);
}

void interpolateHanging(const grid::BlockSet& blocks, std::span<const HangingVertex> vertices, UnionFind& joined,
                        SheetMesh& mesh)
{
	Interpolator(blocks, joined, mesh).interpolate(vertices);
}

} // namespace vp::mesh
