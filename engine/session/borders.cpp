#include "session/borders.h"

#include "base/place_key.h"
#include "measure/components.h"
#include "mesh/union_find.h"
#include "session/hanging_borders.h"
#include "session/rim_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vp::session
{

namespace
{

int ownerOf(std::uint64_t key, const Team& team)
{
	return static_cast<int>((key ^ key >> 32) % static_cast<std::uint64_t>(team.size()));
}

struct SentFace
{
	FaceKey key;
	std::uint32_t polygon;
	bool is_boundary; // of a cell that is not cut
};

FaceKey faceKey(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	FaceKey key;
	for (const std::uint32_t v : mesh.polygon(polygon))
		addCorner(mesh.positions[v], key);
	return key;
}

bool hasOnlyGridPoints(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	return std::ranges::all_of(mesh.polygon(polygon), [&](std::uint32_t v)
	                           { return v >= mesh.edges.size() || mesh.edges[v].t == 0.0 || mesh.edges[v].t == 1.0; });
}

void dropPolygons(const std::vector<std::uint32_t>& dropped, mesh::SheetMesh& mesh)
{
	mesh::SheetMesh kept;
	kept.polygon_starts.push_back(0);
	auto next = dropped.begin();
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		if (next != dropped.end() && *next == p)
		{
			++next;
			continue;
		}
		for (const std::uint32_t v : mesh.polygon(p))
			kept.polygon_vertices.push_back(v);
		kept.polygon_starts.push_back(static_cast<std::uint32_t>(kept.polygon_vertices.size()));
		kept.polygon_cells.push_back(mesh.polygon_cells[p]);
	}
	mesh.polygon_vertices = std::move(kept.polygon_vertices);
	mesh.polygon_starts = std::move(kept.polygon_starts);
	mesh.polygon_cells = std::move(kept.polygon_cells);
	mesh.boundary_polygons -= dropped.size();
	mesh::dropUnusedVertices(mesh);
}

std::vector<Bytes> taken(std::vector<MessageWriter>& messages)
{
	std::vector<Bytes> bytes;
	for (MessageWriter& message : messages)
		bytes.push_back(message.take());
	return bytes;
}

/// Of faces in the plane that lie on each other, one is shown: the polygon of a cut cell, or the first.
std::size_t dropFacesShownElsewhere(Team& team, mesh::SheetMesh& mesh)
{
	if (!anyOf(team, mesh.boundary_polygons > 0))
		return 0;
	std::vector<MessageWriter> asked(static_cast<std::size_t>(team.size()));
	const std::size_t first_boundary = mesh.polygons() - mesh.boundary_polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		if (p >= first_boundary || hasOnlyGridPoints(mesh, p))
		{
			const FaceKey key = faceKey(mesh, p);
			asked[static_cast<std::size_t>(ownerOf(key.sum, team))].put(
			    SentFace{key, static_cast<std::uint32_t>(p), p >= first_boundary});
		}
	const std::vector<Bytes> came = team.exchange(taken(asked));
	struct Shown
	{
		int rank;
		SentFace face;
	};
	std::map<FaceKey, std::vector<Shown>> faces;
	for (int rank = 0; rank < team.size(); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			const auto face = reader.get<SentFace>();
			faces[face.key].push_back({rank, face});
		}
	std::vector<MessageWriter> answers(static_cast<std::size_t>(team.size()));
	for (const auto& [key, shown] : faces)
	{
		bool is_taken = std::ranges::any_of(shown, [](const Shown& s) { return !s.face.is_boundary; });
		for (const Shown& s : shown)
			if (s.face.is_boundary && std::exchange(is_taken, true))
				answers[static_cast<std::size_t>(s.rank)].put(s.face.polygon);
	}
	std::vector<std::uint32_t> dropped;
	for (const Bytes& answer : team.exchange(taken(answers)))
		for (MessageReader reader(answer); !reader.atEnd();)
			dropped.push_back(reader.get<std::uint32_t>());
	std::ranges::sort(dropped);
	if (!dropped.empty())
		dropPolygons(dropped, mesh);
	return dropped.size();
}

/// Pieces of two ranks that hang together.
struct Link
{
	int rank;
	std::uint32_t component;
	int other;
	std::uint32_t other_component;

	auto operator<=>(const Link&) const = default;
};

std::size_t countTogether(Team& team, std::size_t own, const std::vector<Link>& links)
{
	MessageWriter message;
	message.put(own);
	message.putAll(links);
	std::vector<std::size_t> first; // number of the first component of each rank
	std::size_t all = 0;
	std::vector<Link> of_all;
	for (const Bytes& bytes : team.gatherAll(message.take()))
	{
		MessageReader reader(bytes);
		first.push_back(all);
		all += reader.get<std::size_t>();
		const auto some = reader.getAll<Link>();
		of_all.insert(of_all.end(), some.begin(), some.end());
	}
	mesh::UnionFind pieces(all);
	for (const Link& link : of_all)
		pieces.join(static_cast<std::uint32_t>(first[static_cast<std::size_t>(link.rank)] + link.component),
		            static_cast<std::uint32_t>(first[static_cast<std::size_t>(link.other)] + link.other_component));
	return pieces.count();
}

/// What the owners of places find.
struct Found
{
	std::vector<Link> links;
	std::vector<std::vector<std::uint32_t>> counted;   // per rank, its vertices that count with one of another rank
	std::vector<std::vector<const RimVertex*>> groups; // vertices that are one
};

/// Joins vertices that may be one. isPlace(a, b): whether they are at one place; isSeam(a, b): whether faces meet
/// there.
template <class IsPlace, class IsSeam>
void joinAmong(std::span<const RimVertex> vertices, const IsPlace& isPlace, const IsSeam& isSeam, Found& found)
{
	mesh::UnionFind joined(vertices.size());
	for (std::uint32_t i = 0; i < vertices.size(); ++i)
		for (std::uint32_t j = 0; j < i; ++j)
		{
			const RimVertex& a = vertices[j];
			const RimVertex& b = vertices[i];
			if (a.rank == b.rank || !isPlace(a, b))
				continue;
			const bool is_seam = isSeam(a, b);
			const bool is_one = (is_seam || a.whole != b.whole) && a.hasDataOf(b);
			if (is_one)
				joined.join(j, i);
			if (is_one || is_seam)
				found.links.push_back({a.rank, a.component, b.rank, b.component});
		}
	std::map<std::uint32_t, std::vector<const RimVertex*>> groups;
	for (std::uint32_t i = 0; i < vertices.size(); ++i)
	{
		groups[joined.root(i)].push_back(&vertices[i]);
		if (joined.root(i) != i)
			found.counted[static_cast<std::size_t>(vertices[i].rank)].push_back(vertices[i].vertex);
	}
	for (auto& [root, group] : groups)
		if (group.size() > 1)
			found.groups.push_back(std::move(group));
}

/// Tells each rank its vertices that are one with those of others.
void tellGroups(Team& team, const Found& found, std::uint64_t round, std::vector<SharedVertex>& shared)
{
	std::vector<MessageWriter> messages(static_cast<std::size_t>(team.size()));
	std::uint64_t id = static_cast<std::uint64_t>(team.rank()) << 33 | round << 32;
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
			MessageWriter& message = messages[static_cast<std::size_t>(vertex->rank)];
			message.put(vertex->vertex);
			message.put(id);
			message.putAll(others);
		}
	}
	for (const Bytes& bytes : team.exchange(taken(messages)))
		for (MessageReader reader(bytes); !reader.atEnd();)
		{
			SharedVertex& vertex = shared.emplace_back();
			vertex.vertex = reader.get<std::uint32_t>();
			vertex.id = reader.get<std::uint64_t>();
			vertex.ranks = reader.getAll<int>();
		}
}

/// Sends vertices to the owners of the bins that they lie in, joins those of each bin, and drops the vertices that are
/// counted elsewhere. binsOf(vertex): a key for each of its bins.
template <class BinsOf, class Join>
void joinInBins(Team& team, std::vector<RimVertex>& own, std::vector<Link>& links, Borders& borders,
                std::uint64_t round, const BinsOf& binsOf, const Join& join)
{
	const auto ranks = static_cast<std::size_t>(team.size());
	std::vector<MessageWriter> messages(ranks);
	for (const RimVertex& vertex : own)
		for (const std::uint64_t bin : binsOf(vertex))
		{
			MessageWriter& message = messages[static_cast<std::size_t>(ownerOf(bin, team))];
			message.put(bin);
			put(message, vertex);
		}
	std::map<std::uint64_t, std::vector<RimVertex>> bins;
	const std::vector<Bytes> came = team.exchange(taken(messages));
	for (int rank = 0; rank < team.size(); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			const auto bin = reader.get<std::uint64_t>();
			bins[bin].push_back(takeVertex(reader, rank));
		}
	Found found;
	found.counted.resize(ranks);
	for (const auto& [bin, vertices] : bins)
		join(bin, vertices, found);
	links.insert(links.end(), found.links.begin(), found.links.end());
	tellGroups(team, found, round, borders.shared);
	std::vector<MessageWriter> answers(ranks);
	for (std::size_t rank = 0; rank < ranks; ++rank)
		answers[rank].putAll(found.counted[rank]);
	std::set<std::uint32_t> counted;
	for (const Bytes& answer : team.exchange(taken(answers)))
		for (const std::uint32_t vertex : MessageReader(answer).getAll<std::uint32_t>())
			counted.insert(vertex);
	std::erase_if(own, [&](const RimVertex& vertex) { return counted.contains(vertex.vertex); });
}

void joinAtSamePlace(Team& team, std::vector<RimVertex>& own, std::vector<Link>& links, Borders& borders)
{
	joinInBins(
	    team, own, links, borders, 0, [](const RimVertex& vertex) { return std::array{placeKey(vertex.place)}; },
	    [](std::uint64_t, const std::vector<RimVertex>& vertices, Found& found)
	    {
		    joinAmong(
		        vertices, [](const RimVertex& a, const RimVertex& b) { return a.place == b.place; },
		        [](const RimVertex& a, const RimVertex& b) { return a.isAcross(b) || !(a.on_edge || b.on_edge); },
		        found);
	    });
}

/// Of a lattice over space whose cells have this side.
std::uint64_t binAt(const Vec3& place, double side)
{
	return placeKey({std::floor(place.x / side), std::floor(place.y / side), std::floor(place.z / side)});
}

/// Places that only rounding has parted, as the coordinates of abutting blocks often are.
void joinNear(Team& team, std::vector<RimVertex>& own, std::vector<Link>& links, Borders& borders)
{
	double side = 0.0;
	for (const RimVertex& vertex : own)
		side = std::max(side, 4.0 * vertex.near);
	sumOverAll(team, side, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	if (!(side > 0.0))
		return;
	joinInBins(
	    team, own, links, borders, 1,
	    [side](const RimVertex& vertex)
	    {
		    std::set<std::uint64_t> bins;
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
			               binAt(0.5 * (a.place + b.place), side) == bin;
		        },
		        [](const RimVertex& a, const RimVertex& b) { return a.on_edge && b.on_edge && a.isOnSameEdge(b); },
		        found);
	    });
}

/// Numbers the pieces of a mesh: per vertex.
std::vector<std::uint32_t> componentsOf(const mesh::SheetMesh& mesh, std::size_t& count)
{
	mesh::UnionFind pieces = measure::joinedVertices(mesh);
	std::unordered_map<std::uint32_t, std::uint32_t> numbers; // by the vertex that stands for a piece
	std::vector<std::uint32_t> components(mesh.positions.size());
	for (std::uint32_t v = 0; v < components.size(); ++v)
		components[v] = numbers.try_emplace(pieces.root(v), static_cast<std::uint32_t>(numbers.size())).first->second;
	count = numbers.size();
	return components;
}

} // namespace

Borders joinBorders(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                    std::span<const find::BlockCut> cuts, mesh::SheetMesh& mesh)
{
	Borders borders;
	borders.faces_elsewhere = dropFacesShownElsewhere(team, mesh);
	std::size_t count = 0;
	const std::vector<std::uint32_t> components = componentsOf(mesh, count);
	std::vector<RimVertex> rim = rimVertices(blocks, whole, cuts, components, mesh);
	const std::size_t all = rim.size();
	std::vector<Link> links;
	joinAtSamePlace(team, rim, links, borders);
	joinNear(team, rim, links, borders);
	borders.vertices_elsewhere = all - rim.size();
	std::ranges::sort(links);
	links.erase(std::unique(links.begin(), links.end()), links.end());
	borders.hangs = hangsBetweenRanks(team, mesh, rim);
	borders.components = countTogether(team, count, links);
	return borders;
}

} // namespace vp::session
