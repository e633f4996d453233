#include "ranks/join/unmatched_faces.h"

#include "ranks/space_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace vp::ranks
{

Vec3 UnmatchedFace::center() const
{
	Vec3 sum(0.0);
	for (const Vec3& corner : corners)
		sum += corner;
	return sum / static_cast<double>(corners.size());
}

Box UnmatchedFace::box() const
{
	Box box;
	for (const Vec3& corner : corners)
		box.include(corner);
	return box;
}

namespace
{

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

struct FaceOfRank
{
	int rank;
	std::uint32_t index; // among those that its rank has given
	UnmatchedFace face;
};

void put(MessageWriter& to, std::uint32_t index, const UnmatchedFace& face)
{
	to.put(index);
	to.put(face.cell.block);
	to.put(face.number);
	to.put(face.tolerance);
	to.putAll(face.corners);
}

FaceOfRank takeLoneFace(MessageReader& from, int rank)
{
	FaceOfRank sent{rank, from.get<std::uint32_t>(), {}};
	sent.face.cell.block = from.get<std::uint32_t>();
	sent.face.number = from.get<std::uint32_t>();
	sent.face.tolerance = from.get<grid::FaceTolerance>();
	sent.face.corners = from.getAll<Vec3>();
	return sent;
}

/// Brings some of the faces together in bins, and calls visit(a, b) for those of different ranks that share one, for
/// each order of the two. A pair may share several bins. boxOf(face): no larger than a bin.
template <class BoxOf, class Visit>
void forPairs(Neighborhood& near, const SpaceBins& bins, std::span<const UnmatchedFace> faces,
              std::span<const std::uint32_t> some, const BoxOf& boxOf, const Visit& visit)
{
	for (const std::uint32_t index : some)
	{
		const Box box = boxOf(faces[index]);
		for (const auto& [bin, place] : bins.of(box.lo, box.hi))
		{
			MessageWriter& message = near.messageFor(place);
			message.put(bin);
			put(message, index, faces[index]);
		}
	}
	std::map<std::uint64_t, std::vector<FaceOfRank>> in_bin;
	const std::vector<Bytes> came = near.exchange();
	for (int rank = 0; rank < static_cast<int>(came.size()); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			const auto bin = reader.get<std::uint64_t>();
			in_bin[bin].push_back(takeLoneFace(reader, rank));
		}
	for (const auto& [bin, together] : in_bin)
		for (const FaceOfRank& a : together)
			for (const FaceOfRank& b : together)
				if (a.rank != b.rank)
					visit(a, b);
}

bool coincide(const UnmatchedFace& a, const UnmatchedFace& b)
{
	const Vec3 apart = grid::toleranceBetween(a.tolerance, b.tolerance);
	const auto isCornerOfB = [&](const Vec3& p)
	{ return std::ranges::any_of(b.corners, [&](const Vec3& q) { return grid::areOnePlace(p, q, apart); }); };
	return a.corners.size() == b.corners.size() && std::ranges::all_of(a.corners, isCornerOfB);
}

/// Returns true if a place lies on the fan of triangles about the center of a face.
bool liesOn(const Vec3& place, const UnmatchedFace& face, double apart)
{
	constexpr double kRounding = 1e-6;
	const Vec3 center = face.center();
	Vec3 before = face.corners.back();
	for (const Vec3& corner : face.corners)
	{
		const Vec3 a = std::exchange(before, corner) - center;
		const Vec3 b = corner - center;
		const Vec3 normal = glm::cross(a, b);
		const double square = glm::dot(normal, normal);
		if (!(square > 0.0))
			continue;
		const Vec3 way = place - center;
		const double of_a = glm::dot(glm::cross(way, b), normal) / square;
		const double of_b = glm::dot(glm::cross(a, way), normal) / square;
		if (of_a >= -kRounding && of_b >= -kRounding && of_a + of_b <= 1.0 + kRounding &&
		    std::abs(glm::dot(way, normal)) <= apart * std::sqrt(square))
			return true;
	}
	return false;
}

bool isPartOf(const UnmatchedFace& small, const UnmatchedFace& large)
{
	constexpr double kOfEdge = 1e-3;
	const double apart = kOfEdge * shortestSide(small.corners);
	return std::ranges::all_of(small.corners, [&](const Vec3& corner) { return liesOn(corner, large, apart); });
}

double greatestOf(Team& team, double own)
{
	sumOverAll(team, own, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	return own;
}

std::vector<std::vector<FaceAcross>> facesAcross(Team& team, const std::vector<Box>& boxes,
                                                 std::span<const UnmatchedFace> faces)
{
	constexpr double kReach = 2.0; // in tolerances: how far apart the centers of matching faces may be
	std::vector<std::vector<FaceAcross>> across(faces.size());
	std::vector<std::uint32_t> all(faces.size());
	std::iota(all.begin(), all.end(), 0u);
	double side = 0.0;
	for (const UnmatchedFace& face : faces)
		side = std::max(side, 2.0 * kReach * face.tolerance.greatest());
	side = greatestOf(team, side);
	if (!(side > 0.0))
		return across;
	Neighborhood near(team, boxes, 2.0 * side);
	forPairs(
	    near, SpaceBins(side), faces, all,
	    [](const UnmatchedFace& face)
	    {
		    const Vec3 center = face.center();
		    const Vec3 reach = kReach * face.tolerance.corner;
		    return Box{center - reach, center + reach};
	    },
	    [&](const FaceOfRank& a, const FaceOfRank& b)
	    {
		    if (!coincide(a.face, b.face))
			    return;
		    near.messageFor(a.rank).put(a.index);
		    near.messageFor(a.rank).put(FaceAcross{b.rank, b.face.number, b.face.cell.block});
	    });
	for (const Bytes& answer : near.exchange())
		for (MessageReader reader(answer); !reader.atEnd();)
		{
			const auto index = reader.get<std::uint32_t>();
			across[index].push_back(reader.get<FaceAcross>());
		}
	for (std::vector<FaceAcross>& of_face : across) // a pair may share several bins
	{
		std::ranges::sort(of_face);
		of_face.erase(std::unique(of_face.begin(), of_face.end()), of_face.end());
	}
	return across;
}

bool hangs(Team& team, const std::vector<Box>& boxes, std::span<const UnmatchedFace> faces,
           std::span<const std::uint32_t> unmatched)
{
	double side = 0.0;
	for (const std::uint32_t index : unmatched)
		side = std::max(side, faces[index].box().diagonal());
	side = greatestOf(team, side);
	if (!(side > 0.0))
		return false;
	Neighborhood near(team, boxes, 2.0 * side);
	bool found = false;
	forPairs(
	    near, SpaceBins(side), faces, unmatched, [](const UnmatchedFace& face) { return face.box(); },
	    [&](const FaceOfRank& a, const FaceOfRank& b) { found = found || isPartOf(a.face, b.face); });
	return anyOf(team, found);
}

} // namespace

std::optional<UnmatchedFace> unmatchedFace(const grid::BlockSet& blocks, const mesh::BlockCell& cell, int face)
{
	const grid::BlockSeams* seams = blocks.interfaces.of(cell.block);
	if (seams && !seams->of(cell.cell, static_cast<std::uint32_t>(face)).empty())
		return std::nullopt;
	return std::visit(
	    [&](const auto& grid) -> std::optional<UnmatchedFace>
	    {
		    bool has_neighbor = false;
		    grid.forEachNeighbor(cell.cell, face, [&](CellId) { has_neighbor = true; });
		    if (has_neighbor)
			    return std::nullopt;
		    grid::CellFaces faces;
		    grid.cellFaces(cell.cell, faces);
		    UnmatchedFace lone;
		    lone.cell = cell;
		    lone.corners = cornersOf(grid, faces[face]);
		    if (lone.corners.size() < 3)
			    return std::nullopt;
		    lone.tolerance = grid::toleranceOf(grid, faces, face, lone.corners);
		    return lone;
	    },
	    blocks.blocks[cell.block].grid);
}

bool areOneLattice(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole, std::uint32_t a, std::uint32_t b)
{
	return whole[a] == whole[b] && !std::holds_alternative<grid::UnstructuredGrid>(blocks.blocks[a].grid);
}

MatchedFaces matchFaces(Team& team, const std::vector<Box>& boxes, std::span<const UnmatchedFace> faces)
{
	MatchedFaces matched{facesAcross(team, boxes, faces)};
	std::vector<std::uint32_t> unmatched;
	for (std::uint32_t f = 0; f < faces.size(); ++f)
		if (matched.across[f].empty())
			unmatched.push_back(f);
	matched.hang = hangs(team, boxes, faces, unmatched);
	return matched;
}

} // namespace vp::ranks
