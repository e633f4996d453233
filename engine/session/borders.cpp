#include "session/borders.h"

#include "base/place_key.h"
#include "measure/components.h"
#include "mesh/mesh_values.h"
#include "mesh/open_vertices.h"
#include "mesh/union_find.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
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

/// A face by its corners, in whatever order.
struct FaceKey
{
	std::uint64_t sum = 0;
	std::uint64_t mixed = 0;
	std::uint64_t corners = 0;

	auto operator<=>(const FaceKey&) const = default;
};

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
	{
		const std::uint64_t place = placeKey(mesh.positions[v]);
		key.sum += place;
		key.mixed ^= (place >> 7) * 0xD1B54A32D192ED03ull;
		++key.corners;
	}
	return key;
}

bool hasOnlyGridPoints(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	return std::ranges::all_of(mesh.polygon(polygon),
	                           [&](std::uint32_t v)
	                           { return v >= mesh.edges.size() || mesh.edges[v].t == 0.0 || mesh.edges[v].t == 1.0; });
}

std::vector<std::uint8_t> rimOf(const mesh::SheetMesh& mesh)
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
		rim[v] = open.isOpen(v);
	return rim;
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

/// A component of a point array at a vertex, and how large the numbers are that it was interpolated from.
struct ValueAt
{
	double value;
	double scale;

	bool isSame(const ValueAt& other) const // as where vertices are joined in one process (mesh/join_vertices.cpp)
	{
		return std::abs(value - other.value) <= 1e-5 * scale || (std::isnan(value) && std::isnan(other.value));
	}
};

bool isId(const grid::Field& field)
{
	using enum grid::NumberType;
	return field.type == int32 || field.type == uint32 || field.type == int64 || field.type == uint64;
}

struct RimVertex
{
	int rank = 0;
	Vec3 place{};
	std::uint32_t component = 0;
	std::vector<std::pair<std::string, std::vector<ValueAt>>> arrays{}; // by name

	bool hasDataOf(const RimVertex& other) const
	{
		return std::ranges::equal(arrays, other.arrays,
		                          [](const auto& a, const auto& b) {
			                          return a.first == b.first &&
			                                 std::ranges::equal(a.second, b.second, [](const ValueAt& x, const ValueAt& y)
			                                                    { return x.isSame(y); });
		                          });
	}
};

/// The names of the arrays go once for each block.
void putVertex(MessageWriter& to, const grid::BlockSet& blocks, const mesh::SheetMesh& mesh, std::uint32_t v,
               std::uint32_t component)
{
	to.put(mesh.positions[v]);
	to.put(component);
	std::vector<const grid::Field*> fields;
	if (v < mesh.edges.size())
		for (const grid::Field& field : blocks.blocks[mesh.edges[v].block].fields)
			if (field.association == grid::Association::point)
				fields.push_back(&field);
	std::ranges::sort(fields, {}, &grid::Field::name);
	to.put(fields.size());
	for (const grid::Field* field : fields)
	{
		to.put(field->name);
		std::vector<ValueAt> values;
		for (int c = 0; c < field->components && !isId(*field); ++c)
		{
			mesh::EdgePoint at = mesh.edges[v];
			const grid::Block& block = blocks.blocks[at.block];
			ValueAt value{mesh::interpolate(block, *field, c, at), 0.0};
			for (const double t : {0.0, 1.0})
			{
				at.t = t;
				value.scale = std::max(value.scale, std::abs(mesh::interpolate(block, *field, c, at)));
			}
			values.push_back(value);
		}
		to.putAll(values);
	}
}

RimVertex vertexOf(MessageReader& from, int rank)
{
	RimVertex vertex{rank};
	vertex.place = from.get<Vec3>();
	vertex.component = from.get<std::uint32_t>();
	for (auto left = from.get<std::size_t>(); left > 0; --left)
	{
		std::string name = from.getText();
		vertex.arrays.emplace_back(std::move(name), from.getAll<ValueAt>());
	}
	return vertex;
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

/// Vertices of several ranks at one place. counted: gets how many of each rank count with those of another.
void joinAtPlace(const std::vector<RimVertex>& vertices, std::vector<Link>& links, std::vector<std::size_t>& counted)
{
	std::vector<const RimVertex*> kept;
	for (const RimVertex& vertex : vertices)
	{
		const auto same = std::ranges::find_if(kept, [&](const RimVertex* other)
		                                       { return other->rank != vertex.rank && other->hasDataOf(vertex); });
		if (same == kept.end())
			kept.push_back(&vertex);
		else
			++counted[static_cast<std::size_t>(vertex.rank)];
		if (const RimVertex& first = vertices.front(); first.rank != vertex.rank)
			links.push_back({first.rank, first.component, vertex.rank, vertex.component});
	}
}

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

} // namespace

Borders joinBorders(Team& team, const grid::BlockSet& blocks, mesh::SheetMesh& mesh)
{
	Borders borders;
	borders.faces_elsewhere = dropFacesShownElsewhere(team, mesh);
	mesh::UnionFind pieces = measure::joinedVertices(mesh);
	std::unordered_map<std::uint32_t, std::uint32_t> components; // by the vertex that stands for one
	std::vector<MessageWriter> messages(static_cast<std::size_t>(team.size()));
	const std::vector<std::uint8_t> rim = rimOf(mesh);
	for (std::uint32_t v = 0; v < rim.size(); ++v)
	{
		const auto number = static_cast<std::uint32_t>(components.size());
		const std::uint32_t component = components.try_emplace(pieces.root(v), number).first->second;
		if (rim[v])
			putVertex(messages[static_cast<std::size_t>(ownerOf(placeKey(mesh.positions[v]), team))], blocks, mesh, v,
			          component);
	}
	const std::vector<Bytes> came = team.exchange(taken(messages));
	std::map<std::tuple<double, double, double>, std::vector<RimVertex>> places;
	for (int rank = 0; rank < team.size(); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			RimVertex vertex = vertexOf(reader, rank);
			const Vec3 at = vertex.place + 0.0; // no -0
			places[{at.x, at.y, at.z}].push_back(std::move(vertex));
		}
	std::vector<Link> links;
	std::vector<std::size_t> counted(static_cast<std::size_t>(team.size()));
	for (const auto& [place, vertices] : places)
		joinAtPlace(vertices, links, counted);
	std::ranges::sort(links);
	const auto repeated = std::ranges::unique(links);
	links.erase(repeated.begin(), repeated.end());

	std::vector<MessageWriter> answers(static_cast<std::size_t>(team.size()));
	for (std::size_t rank = 0; rank < answers.size(); ++rank)
		answers[rank].put(counted[rank]);
	for (const Bytes& answer : team.exchange(taken(answers)))
		borders.vertices_elsewhere += MessageReader(answer).get<std::size_t>();
	borders.components = countTogether(team, components.size(), links);
	return borders;
}

} // namespace vp::session
