#include "session/lone_faces.h"

#include "base/place_key.h"
#include "session/hanging_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace vp::session
{

Vec3 LoneFace::center() const
{
	Vec3 sum(0.0);
	for (const Vec3& corner : corners)
		sum += corner;
	return sum / static_cast<double>(corners.size());
}

bool LoneFace::liesOn(const LoneFace& other) const
{
	const double apart = std::min({std::max(tolerance, other.tolerance), most, other.most});
	const auto isCorner = [&](const Vec3& p)
	{ return std::ranges::any_of(other.corners, [&](const Vec3& q) { return glm::length(p - q) <= apart; }); };
	return corners.size() == other.corners.size() && std::ranges::all_of(corners, isCorner);
}

namespace
{

template <grid::Grid G>
double storedUlp(const G& grid)
{
	if constexpr (requires { grid.coordinates().isDouble(); })
		if (!grid.coordinates().isDouble())
			return std::numeric_limits<float>::epsilon();
	return std::numeric_limits<double>::epsilon();
}

template <grid::Grid G>
std::vector<Vec3> cornersOf(const G& grid, std::span<const PointId> face)
{
	std::vector<Vec3> corners;
	for (const PointId p : face)
		if (const Vec3 corner = grid.point(p); std::ranges::find(corners, corner) == corners.end())
			corners.push_back(corner);
	return corners;
}

double shortestSide(std::span<const Vec3> corners)
{
	double shortest = std::numeric_limits<double>::infinity();
	Vec3 before = corners.back();
	for (const Vec3& corner : corners)
		if (const double length = glm::length(corner - std::exchange(before, corner)); length > 0.0)
			shortest = std::min(shortest, length);
	return shortest;
}

/// As grid/interfaces.h has it.
template <grid::Grid G>
void setTolerance(const G& grid, const grid::CellFaces& faces, LoneFace& face)
{
	constexpr double kOfEdge = 1e-6;
	constexpr double kMaxOfAnEdge = 0.25;
	const double edge = shortestSide(face.corners);
	double greatest = 0.0;
	for (const Vec3& corner : face.corners)
		greatest = std::max({greatest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
	double shortest_of_cell = std::numeric_limits<double>::infinity();
	for (int f = 0; f < faces.size(); ++f)
		shortest_of_cell = std::min(shortest_of_cell, shortestSide(cornersOf(grid, faces[f])));
	face.tolerance = std::max(kOfEdge * edge, std::min(4.0 * storedUlp(grid) * greatest, kMaxOfAnEdge * edge));
	face.most = kMaxOfAnEdge * shortest_of_cell;
}

struct FaceOfRank
{
	int rank;
	std::uint32_t number;
	LoneFace face;
};

void put(MessageWriter& to, std::uint32_t number, const LoneFace& face)
{
	to.put(number);
	to.put(face.tolerance);
	to.put(face.most);
	to.putAll(face.corners);
}

FaceOfRank takeLoneFace(MessageReader& from, int rank)
{
	FaceOfRank sent{rank, from.get<std::uint32_t>(), {}};
	sent.face.tolerance = from.get<double>();
	sent.face.most = from.get<double>();
	sent.face.corners = from.getAll<Vec3>();
	return sent;
}

} // namespace

std::optional<LoneFace> loneFace(const grid::BlockSet& blocks, const mesh::BlockCell& cell, int face)
{
	const grid::BlockSeams* seams = blocks.interfaces.of(cell.block);
	if (seams && !seams->of(cell.cell, static_cast<std::uint32_t>(face)).empty())
		return std::nullopt;
	return std::visit(
	    [&](const auto& grid) -> std::optional<LoneFace>
	    {
		    bool has_neighbor = false;
		    grid.forEachNeighbor(cell.cell, face, [&](CellId) { has_neighbor = true; });
		    if (has_neighbor)
			    return std::nullopt;
		    grid::CellFaces faces;
		    grid.cellFaces(cell.cell, faces);
		    LoneFace lone;
		    lone.cell = cell;
		    lone.corners = cornersOf(grid, faces[face]);
		    if (lone.corners.size() < 3)
			    return std::nullopt;
		    setTolerance(grid, faces, lone);
		    return lone;
	    },
	    blocks.blocks[cell.block].grid);
}

std::vector<std::vector<FaceAcross>> facesAcross(Team& team, const std::vector<Box>& boxes,
                                                 std::span<const LoneFace> faces)
{
	std::vector<std::vector<FaceAcross>> across(faces.size());
	double side = 0.0; // of the bins of a lattice over space
	for (const LoneFace& face : faces)
		for (const Vec3& corner : face.corners)
			side = std::max(side, 2.0 * glm::length(corner - face.center()));
	sumOverAll(team, side, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	if (!(side > 0.0))
		return across;
	const auto binAt = [&](const Vec3& place)
	{
		const Vec3 cell(std::floor(place.x / side), std::floor(place.y / side), std::floor(place.z / side));
		return std::pair(placeKey(cell), side * (cell + 0.5));
	};
	Neighborhood near(team, boxes, side); // the middle of a bin lies no farther from the faces in it
	for (std::uint32_t f = 0; f < faces.size(); ++f)
	{
		std::map<std::uint64_t, Vec3> bins;
		for (int corner = 0; corner < 8; ++corner)
		{
			const Vec3 way(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
			bins.insert(binAt(faces[f].center() + 2.0 * faces[f].tolerance * way));
		}
		for (const auto& [bin, place] : bins)
		{
			MessageWriter& message = near.messageFor(place);
			message.put(bin);
			put(message, f, faces[f]);
		}
	}
	std::map<std::uint64_t, std::vector<FaceOfRank>> bins;
	const std::vector<Bytes> came = near.exchange();
	for (std::size_t rank = 0; rank < came.size(); ++rank)
		for (MessageReader reader(came[rank]); !reader.atEnd();)
		{
			const auto bin = reader.get<std::uint64_t>();
			bins[bin].push_back(takeLoneFace(reader, static_cast<int>(rank)));
		}
	for (const auto& [bin, some] : bins)
		for (const FaceOfRank& a : some)
			for (const FaceOfRank& b : some)
				if (a.rank != b.rank && a.face.liesOn(b.face))
				{
					near.messageFor(a.rank).put(a.number);
					near.messageFor(a.rank).put(FaceAcross{b.rank, b.number});
				}
	for (const Bytes& answer : near.exchange())
		for (MessageReader reader(answer); !reader.atEnd();)
		{
			const auto number = reader.get<std::uint32_t>();
			across[number].push_back(reader.get<FaceAcross>());
		}
	for (std::vector<FaceAcross>& of_face : across) // a pair may share several bins
	{
		std::ranges::sort(of_face);
		of_face.erase(std::unique(of_face.begin(), of_face.end()), of_face.end());
	}
	return across;
}

bool facesHang(Team& team, const std::vector<Box>& boxes, std::span<const LoneFace> faces,
               std::span<const std::vector<FaceAcross>> across)
{
	mesh::SheetMesh lone;
	lone.polygon_starts.push_back(0);
	std::unordered_map<std::uint64_t, std::uint32_t> vertices; // by place
	std::vector<RimVertex> corners;
	for (std::size_t f = 0; f < faces.size(); ++f)
	{
		if (!across[f].empty())
			continue;
		for (const Vec3& place : faces[f].corners)
		{
			const auto next = static_cast<std::uint32_t>(lone.positions.size());
			const auto [at, is_new] = vertices.try_emplace(placeKey(place), next);
			lone.polygon_vertices.push_back(at->second);
			if (!is_new)
				continue;
			lone.positions.push_back(place);
			RimVertex& corner = corners.emplace_back();
			corner.place = place;
			corner.near = faces[f].apart();
		}
		lone.polygon_starts.push_back(static_cast<std::uint32_t>(lone.polygon_vertices.size()));
		lone.polygon_cells.push_back(faces[f].cell);
	}
	return hangsBetweenRanks(team, boxes, lone, corners);
}

BoxesOfOthers::BoxesOfOthers(const Team& team, const std::vector<Box>& boxes)
{
	Box all;
	for (const Box& box : boxes)
		all.include(box);
	constexpr double kRounding = 1e-6; // of places against the bounds of their cells
	for (int rank = 0; rank < team.size(); ++rank)
		if (Box box = boxes[static_cast<std::size_t>(rank)]; rank != team.rank() && !box.empty())
		{
			box.lo -= kRounding * all.diagonal();
			box.hi += kRounding * all.diagonal();
			boxes_.push_back(box);
		}
}

bool BoxesOfOthers::meet(const Box& box) const
{
	return std::ranges::any_of(
	    boxes_, [&](const Box& other)
	    { return glm::all(glm::lessThanEqual(box.lo, other.hi)) && glm::all(glm::lessThanEqual(other.lo, box.hi)); });
}

} // namespace vp::session
