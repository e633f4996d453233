#include "ranks/join/borders.h"

#include "base/place_key.h"
#include "base/union_find.h"
#include "measure/components.h"
#include "ranks/data/share.h"
#include "ranks/join/border_faces.h"
#include "ranks/join/hanging_borders.h"
#include "ranks/join/rim_vertices.h"
#include "ranks/joined_across.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vp::ranks
{

namespace
{

/// The links and groups of vertices that the owners of places find.
struct Found
{
	std::vector<Link> links;
	std::vector<std::vector<std::uint32_t>> counted;   // per rank, its vertices that count with one of another rank
	std::vector<std::vector<const RimVertex*>> groups; // vertices that lie on each other
};

/// Joins vertices that may be one. isPlace(a, b): whether they are at one place; isSeam(a, b): whether faces meet
/// there.
template <class IsPlace, class IsSeam>
void joinAmong(std::span<const RimVertex> vertices, const IsPlace& isPlace, const IsSeam& isSeam, Found& found)
{
	UnionFind joined(vertices.size());
	UnionFind touching(vertices.size());
	// As in one process, a place has one vertex of each block where only places tell (mesh/join_vertices.cpp).
	const auto isFirst = [&](std::uint32_t i)
	{
		return std::ranges::none_of(
		    vertices.first(i), [&](const RimVertex& v)
		    { return v.rank == vertices[i].rank && v.whole == vertices[i].whole && v.place == vertices[i].place; });
	};
	for (std::uint32_t i = 0; i < vertices.size(); ++i)
		for (std::uint32_t j = 0; j < i; ++j)
		{
			const RimVertex& a = vertices[j];
			const RimVertex& b = vertices[i];
			if (a.rank == b.rank || !isPlace(a, b))
				continue;
			const bool is_seam = isSeam(a, b);
			const bool is_one = (is_seam || (a.whole != b.whole && isFirst(i) && isFirst(j))) && a.isOneWith(b);
			if (is_one)
				joined.join(j, i);
			if (is_one || is_seam)
				touching.join(j, i);
		}
	std::map<std::uint32_t, std::vector<const RimVertex*>> groups;
	std::set<std::uint32_t> seen; // vertices of the meshes that are one count once
	for (std::uint32_t i = 0; i < vertices.size(); ++i)
	{
		const RimVertex& vertex = vertices[i];
		if (!vertex.isInMesh())
			continue;
		std::vector<const RimVertex*>& group = groups[touching.root(i)];
		if (!group.empty())
			found.links.push_back({group[0]->rank, group[0]->component, vertex.rank, vertex.component});
		group.push_back(&vertex);
		if (!seen.insert(joined.root(i)).second)
			found.counted[static_cast<std::size_t>(vertex.rank)].push_back(vertex.vertex);
	}
	for (auto& [root, group] : groups)
		if (group.size() > 1)
			found.groups.push_back(std::move(group));
}

/// Tells each rank its vertices that lie on those of others.
void tellGroups(Neighborhood& near, std::uint64_t first_id, const Found& found, std::vector<SharedVertex>& shared)
{
	std::uint64_t id = first_id;
	for (const auto& group : found.groups)
	{
		++id;
		for (const RimVertex* vertex : group)
		{
			std::vector<int> others;
			for (const RimVertex* other : group)
				if (other->rank != vertex->rank)
					others.push_back(other->rank);
			std::ranges::sort(others);
			others.erase(std::unique(others.begin(), others.end()), others.end());
			MessageWriter& message = near.messageFor(vertex->rank);
			message.put(vertex->vertex);
			message.put(id);
			message.putAll(others);
		}
	}
	for (const Bytes& bytes : near.exchange())
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			SharedVertex& vertex = shared.emplace_back();
			vertex.vertex = reader.get<std::uint32_t>();
			vertex.id = reader.get<std::uint64_t>();
			vertex.ranks = reader.getAll<int>();
		}
}

/// The number of a bin, and a place in it.
using PlacedBin = std::pair<std::uint64_t, Vec3>;

/// Sends vertices to the owners of the bins that they lie in, joins those of each bin, and drops the vertices that are
/// counted elsewhere. binsOf(vertex): each of its bins. first_id: no other call has given numbers from there on.
template <class BinsOf, class Join>
void joinInBins(Neighborhood& near, std::uint64_t first_id, std::vector<RimVertex>& own, std::vector<Link>& links,
                Borders& borders, const BinsOf& binsOf, const Join& join)
{
	for (const RimVertex& vertex : own)
		for (const auto& [bin, place] : binsOf(vertex))
		{
			MessageWriter& message = near.messageFor(place);
			message.put(bin);
			put(message, vertex);
		}
	std::map<std::uint64_t, std::vector<RimVertex>> bins;
	const std::vector<Bytes> came = near.exchange();
	for (std::size_t rank = 0; rank < came.size(); ++rank)
		for (MessageReader reader(came[rank]); !reader.atEnd();)
		{
			const auto bin = reader.get<std::uint64_t>();
			bins[bin].push_back(takeVertex(reader, static_cast<int>(rank)));
		}
	Found found;
	found.counted.resize(came.size());
	for (const auto& [bin, vertices] : bins)
		join(bin, vertices, found);
	links.insert(links.end(), found.links.begin(), found.links.end());
	tellGroups(near, first_id, found, borders.shared);
	for (std::size_t rank = 0; rank < came.size(); ++rank)
		for (const std::uint32_t vertex : found.counted[rank])
			near.messageFor(static_cast<int>(rank)).put(vertex);
	std::set<std::uint32_t> counted;
	for (const Bytes& answer : near.exchange())
		for (MessageReader reader(answer); !reader.atEnd();)
			counted.insert(reader.get<std::uint32_t>());
	std::erase_if(own, [&](const RimVertex& vertex) { return counted.contains(vertex.vertex); });
}

/// Numbers that only this rank gives, in one round of two.
std::uint64_t firstId(const Team& team, std::uint64_t round)
{
	return static_cast<std::uint64_t>(team.rank()) << 33 | round << 32;
}

void joinAtSamePlace(Team& team, const std::vector<Box>& boxes, std::vector<RimVertex>& own, std::vector<Link>& links,
                     Borders& borders)
{
	Neighborhood near(team, boxes, 0.0);
	borders.peers = near.ranks();
	joinInBins(
	    near, firstId(team, 0), own, links, borders,
	    [](const RimVertex& vertex) { return std::array{PlacedBin(placeKey(vertex.place), vertex.place)}; },
	    [](std::uint64_t, const std::vector<RimVertex>& vertices, Found& found)
	    {
		    joinAmong(
		        vertices, [](const RimVertex& a, const RimVertex& b) { return a.place == b.place; },
		        // Pieces of one lattice and shares of one pack share points, also where only edges of their cells meet.
		        [](const RimVertex& a, const RimVertex& b)
		        {
			        if (!a.on_edge || !b.on_edge)
				        return a.on_edge == b.on_edge;
			        return a.hasSamePoints(b) || (a.isAcross(b) && a.isOnSameEdge(b));
		        },
		        found);
	    });
}

/// Returns the bin of a place, in a lattice over space whose cells have this side.
PlacedBin binAt(const Vec3& place, double side)
{
	const Vec3 cell(std::floor(place.x / side), std::floor(place.y / side), std::floor(place.z / side));
	return {placeKey(cell), side * (cell + 0.5)};
}

/// Places that only rounding has parted, as the coordinates of abutting blocks often are.
void joinNear(Team& team, const std::vector<Box>& boxes, std::vector<RimVertex>& own, std::vector<Link>& links,
              Borders& borders)
{
	double side = 0.0;
	for (const RimVertex& vertex : own)
		side = std::max(side, 4.0 * vertex.near);
	sumOverAll(team, side, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	if (!(side > 0.0))
		return;
	Neighborhood near(team, boxes, side); // the middle of a bin lies no farther from its vertices
	borders.peers = near.ranks();
	joinInBins(
	    near, firstId(team, 1), own, links, borders,
	    [side](const RimVertex& vertex)
	    {
		    std::map<std::uint64_t, Vec3> bins;
		    for (int corner = 0; corner < 8; ++corner)
		    {
			    const Vec3 way(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
			    bins.insert(binAt(vertex.place + vertex.near * way, side));
		    }
		    return bins;
	    },
	    [side](std::uint64_t bin, const std::vector<RimVertex>& vertices, Found& found)
	    {
		    joinAmong(
		        vertices,
		        // Equal ones have been compared. A pair that several bins hold counts in one of them.
		        [&](const RimVertex& a, const RimVertex& b)
		        {
			        return a.place != b.place && glm::length(a.place - b.place) <= std::min(a.near, b.near) &&
			               a.isOnSameEdge(b) && binAt(0.5 * (a.place + b.place), side).first == bin;
		        },
		        [](const RimVertex& a, const RimVertex& b)
		        { return a.on_edge && b.on_edge && !(a.of_pack && b.of_pack); },
		        found);
	    });
}

/// Numbers the pieces of a mesh.
MarkedPieces piecesOf(const mesh::SheetMesh& mesh)
{
	UnionFind joined = measure::joinedVertices(mesh);
	std::vector<std::uint32_t> roots(mesh.positions.size());
	for (std::uint32_t v = 0; v < roots.size(); ++v)
		roots[v] = joined.root(v);
	return numbered(roots);
}

Borders join(Team& team, const std::vector<Box>& boxes, const grid::BlockSet& blocks,
             std::span<const std::uint32_t> whole, std::span<const find::BlockCut> cuts, MarkedPieces& pieces,
             const mesh::SheetMesh& mesh)
{
	Borders borders;
	std::vector<RimVertex> rim = rimVertices(blocks, whole, cuts, pieces.of_vertex, boxesOfOthers(team, boxes), mesh);
	const std::size_t all = rim.size();
	std::vector<Link> links;
	joinAtSamePlace(team, boxes, rim, links, borders);
	joinNear(team, boxes, rim, links, borders);
	borders.vertices_elsewhere = all - rim.size();
	std::erase_if(rim, [](const RimVertex& vertex) { return !vertex.isInMesh(); });
	borders.hangs = hangsBetweenRanks(team, boxes, mesh, rim);
	JoinedAcross together = joinOverRanks(team, pieces.marks, std::move(links));
	borders.components = together.count;
	pieces.marks = std::move(together.marks);
	return borders;
}

} // namespace

void shareVertices(Team& team, const std::vector<Box>& boxes, std::vector<RimVertex>& own, Borders& borders)
{
	const std::size_t all = own.size();
	std::vector<Link> links; // links between pieces, which are not used here
	joinAtSamePlace(team, boxes, own, links, borders);
	joinNear(team, boxes, own, links, borders);
	borders.vertices_elsewhere += all - own.size();
}

MarkedPieces numbered(std::span<const std::uint32_t> roots)
{
	MarkedPieces pieces;
	std::unordered_map<std::uint32_t, std::uint32_t> numbers;
	pieces.of_vertex.reserve(roots.size());
	for (const std::uint32_t root : roots)
		pieces.of_vertex.push_back(numbers.try_emplace(root, static_cast<std::uint32_t>(numbers.size())).first->second);
	pieces.marks.assign(numbers.size(), 0);
	return pieces;
}

Borders joinBorders(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const find::BlockCut> cuts,
                    mesh::SheetMesh& mesh)
{
	if (!ranks.team())
		return {};
	Team& team = *ranks.team();
	const std::vector<Box> boxes = boxesOf(team, blocks);
	std::vector<mesh::BlockCell> cells_elsewhere = dropFacesShownElsewhere(team, boxes, mesh);
	MarkedPieces pieces = piecesOf(mesh);
	Borders borders = join(team, boxes, blocks, ranks.share().whole, cuts, pieces, mesh);
	borders.faces_elsewhere = cells_elsewhere.size();
	borders.cells_elsewhere = std::move(cells_elsewhere);
	return borders;
}

Borders joinBorders(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                    std::span<const find::BlockCut> cuts, MarkedPieces& pieces, const mesh::SheetMesh& mesh)
{
	return join(team, boxesOf(team, blocks), blocks, whole, cuts, pieces, mesh);
}

std::size_t componentsOf(const Ranks& ranks, const Borders& borders, const mesh::SheetMesh& mesh)
{
	return ranks.team() ? borders.components : measure::countComponents(mesh);
}

measure::SheetSums sumUp(const Ranks& ranks, const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                         const std::optional<grid::FieldChoice>& field)
{
	return ranks.sum(measure::sumUp(blocks, mesh, field), [](auto& sum, const auto& other) { sum.add(other); });
}

measure::ValueAreas sumUp(const Ranks& ranks, measure::ValueAreas own)
{
	if (!ranks.team())
		return own;
	const auto bytesOf = [](const measure::ValueAreas& areas)
	{
		MessageWriter message;
		for (const auto& [value, area] : areas)
		{
			message.put(value);
			message.put(area);
		}
		return message.take();
	};
	const auto addFrom = [](const Bytes& bytes, measure::ValueAreas& areas)
	{
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			const auto value = reader.get<double>();
			areas[value] += reader.get<ExactSum>();
		}
	};
	measure::ValueAreas sum;
	for (const Bytes& of_rank : ranks.team()->gatherAll(bytesOf(own)))
		addFrom(of_rank, sum);
	return sum;
}

} // namespace vp::ranks
