#include "ranks/join/polygons_around.h"

#include <set>
#include <unordered_map>
#include <utility>

namespace vp::ranks
{

namespace
{

/// The entries of each vertex that other ranks have too.
using SharedOf = std::unordered_map<std::uint32_t, std::vector<const SharedVertex*>>;

void putPolygon(const mesh::SheetMesh& mesh, std::size_t polygon, const SharedOf& shared, double value,
                MessageWriter& message)
{
	message.put(value);
	message.put(mesh.polygon(polygon).size());
	for (const std::uint32_t v : mesh.polygon(polygon))
	{
		message.put(mesh.positions[v]);
		std::vector<std::uint64_t> ids;
		if (const auto of = shared.find(v); of != shared.end())
			for (const SharedVertex* vertex : of->second)
				ids.push_back(vertex->id);
		message.putAll(ids);
	}
}

/// own: the vertex of this rank for each number that several ranks have.
void takePolygon(MessageReader& from, const std::unordered_map<std::uint64_t, std::uint32_t>& own,
                 mesh::SheetMesh& mesh)
{
	for (auto left = from.get<std::size_t>(); left > 0; --left)
	{
		const auto place = from.get<Vec3>();
		auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
		for (const std::uint64_t id : from.getAll<std::uint64_t>())
			if (const auto known = own.find(id); known != own.end())
				vertex = known->second;
		if (vertex == mesh.positions.size())
			mesh.positions.push_back(place);
		mesh.polygon_vertices.push_back(vertex);
	}
	mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
	mesh.polygon_cells.push_back({});
}

} // namespace

std::size_t addPolygonsAround(Team& team, const Borders& borders, mesh::SheetMesh& mesh,
                              std::vector<double>& of_polygons)
{
	SharedOf shared;
	std::unordered_map<std::uint64_t, std::uint32_t> own;
	for (const SharedVertex& vertex : borders.shared)
	{
		shared[vertex.vertex].push_back(&vertex);
		own[vertex.id] = vertex.vertex;
	}
	const bool has_values = !of_polygons.empty();
	std::vector<MessageWriter> messages(static_cast<std::size_t>(team.size()));
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		std::set<int> ranks;
		for (const std::uint32_t v : mesh.polygon(p))
			if (const auto of = shared.find(v); of != shared.end())
				for (const SharedVertex* vertex : of->second)
					ranks.insert(vertex->ranks.begin(), vertex->ranks.end());
		for (const int rank : ranks)
			putPolygon(mesh, p, shared, has_values ? of_polygons[p] : 0.0, messages[static_cast<std::size_t>(rank)]);
	}
	std::vector<Bytes> bytes;
	for (MessageWriter& message : messages)
		bytes.push_back(message.take());
	const std::size_t before = mesh.polygons();
	for (const Bytes& came : team.exchange(std::move(bytes), borders.peers))
		for (MessageReader reader(came); !reader.atEnd();)
		{
			const auto value = reader.get<double>();
			takePolygon(reader, own, mesh);
			if (has_values)
				of_polygons.push_back(value);
		}
	return mesh.polygons() - before;
}

} // namespace vp::ranks
