#include "ranks/join/border_faces.h"

#include "base/place_key.h"
#include "ranks/join/rim_vertices.h"

#include <algorithm>
#include <map>
#include <utility>

namespace vp::ranks
{

namespace
{

struct SentFace
{
	FaceKey key;
	std::uint32_t polygon;
	bool is_boundary; // the face belongs to a cell that is not cut
};

FaceKey faceKey(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	FaceKey key;
	for (const std::uint32_t v : mesh.polygon(polygon))
		addCorner(mesh.positions[v], key);
	return key;
}

/// One of a polygon's corners, whatever their order.
Vec3 meetingPlace(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	const auto keyOf = [&](std::uint32_t v) { return placeKey(mesh.positions[v]); };
	return mesh.positions[*std::ranges::min_element(mesh.polygon(polygon), {}, keyOf)];
}

bool hasOnlyGridPoints(const mesh::SheetMesh& mesh, std::size_t polygon)
{
	return std::ranges::all_of(mesh.polygon(polygon), [&](std::uint32_t v)
	                           { return v >= mesh.edges.size() || mesh.edges[v].t == 0.0 || mesh.edges[v].t == 1.0; });
}

struct ShownFace
{
	int rank;
	SentFace face;
};

/// Brings faces together at their owners, and drops the polygons that these name. tell(shown, drop): of faces that lie
/// on each other, calls drop(face) for those to be dropped.
template <class Tell>
std::vector<std::uint32_t> facesToDrop(Neighborhood& near, const Tell& tell)
{
	const std::vector<Bytes> came = near.exchange();
	std::map<FaceKey, std::vector<ShownFace>> faces;
	for (int rank = 0; rank < static_cast<int>(came.size()); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			const auto face = reader.get<SentFace>();
			faces[face.key].push_back({rank, face});
		}
	for (const auto& [key, shown] : faces)
		tell(shown, [&](const ShownFace& s) { near.messageFor(s.rank).put(s.face.polygon); });
	std::vector<std::uint32_t> dropped;
	for (const Bytes& answer : near.exchange())
		for (MessageReader reader(answer); !reader.atEnd();)
			dropped.push_back(reader.get<std::uint32_t>());
	std::ranges::sort(dropped);
	return dropped;
}

} // namespace

void dropPolygons(std::span<const std::uint32_t> dropped, mesh::SheetMesh& mesh)
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
		for (std::uint32_t corner = mesh.polygon_starts[p]; corner < mesh.polygon_starts[p + 1]; ++corner)
		{
			kept.polygon_vertices.push_back(mesh.polygon_vertices[corner]);
			if (!mesh.is_added.empty())
				kept.is_added.push_back(mesh.is_added[corner]);
		}
		kept.polygon_starts.push_back(static_cast<std::uint32_t>(kept.polygon_vertices.size()));
		kept.polygon_cells.push_back(mesh.polygon_cells[p]);
	}
	mesh.polygon_vertices = std::move(kept.polygon_vertices);
	mesh.polygon_starts = std::move(kept.polygon_starts);
	mesh.polygon_cells = std::move(kept.polygon_cells);
	mesh.is_added = std::move(kept.is_added);
	mesh::dropUnusedVertices(mesh);
}

std::vector<mesh::BlockCell> dropFacesShownElsewhere(Team& team, const std::vector<Box>& boxes, mesh::SheetMesh& mesh)
{
	if (!anyOf(team, mesh.boundary_polygons > 0))
		return {};
	Neighborhood near(team, boxes, 0.0);
	const std::size_t first_boundary = mesh.polygons() - mesh.boundary_polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
		if (p >= first_boundary || hasOnlyGridPoints(mesh, p))
		{
			const FaceKey key = faceKey(mesh, p);
			near.messageFor(meetingPlace(mesh, p))
			    .put(SentFace{key, static_cast<std::uint32_t>(p), p >= first_boundary});
		}
	const std::vector<std::uint32_t> dropped =
	    facesToDrop(near,
	                [](const std::vector<ShownFace>& shown, const auto& drop)
	                {
		                bool is_taken = std::ranges::any_of(shown, [](const auto& s) { return !s.face.is_boundary; });
		                for (const ShownFace& s : shown)
			                if (s.face.is_boundary && std::exchange(is_taken, true))
				                drop(s);
	                });
	std::vector<mesh::BlockCell> cells;
	for (const std::uint32_t p : dropped)
		cells.push_back(mesh.polygon_cells[p]);
	if (!dropped.empty())
		dropPolygons(dropped, mesh);
	mesh.boundary_polygons -= dropped.size();
	return cells;
}

} // namespace vp::ranks
