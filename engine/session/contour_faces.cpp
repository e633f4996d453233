#include "session/contour_faces.h"

#include "session/neighborhood.h"
#include "session/space_bins.h"
#include "session/together.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace vp::session
{

namespace
{

/// A face through which a contour may lead to another rank.
struct OpenFace
{
	int rank = 0;
	std::uint32_t number = 0; // among the faces of its rank
	std::uint32_t group = 0;
	double edge = 0.0;      // its shortest
	double tolerance = 0.0; // of a corner
	double most = 0.0;      // no tolerance passes it, else a flat cell would meet what lies on its other side
	std::vector<Vec3> corners{};

	Vec3 center() const
	{
		Vec3 sum(0.0);
		for (const Vec3& corner : corners)
			sum += corner;
		return sum / static_cast<double>(corners.size());
	}
	Box box() const
	{
		Box box;
		for (const Vec3& corner : corners)
			box.include(corner);
		return box;
	}
};

/// Calls visit(length) for each side that has one.
template <class Visit>
void forSides(std::span<const Vec3> corners, const Visit& visit)
{
	Vec3 before = corners.back();
	for (const Vec3& corner : corners)
		if (const double length = glm::length(corner - std::exchange(before, corner)); length > 0.0)
			visit(length);
}

/// With the tolerances of grid::matchInterfaces().
OpenFace faceOf(const grid::BlockSet& blocks, const contour::WayOut& way, std::uint32_t number)
{
	constexpr double kOfEdge = 1e-6;
	constexpr double kMostOfEdge = 0.25;
	OpenFace open{.number = number,
	              .group = way.group,
	              .edge = std::numeric_limits<double>::infinity(),
	              .most = std::numeric_limits<double>::infinity()};
	std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces faces;
		    grid.cellFaces(way.face.cell, faces);
		    std::vector<Vec3> corners;
		    for (int f = 0; f < faces.size(); ++f)
		    {
			    corners.clear();
			    for (const PointId p : faces[f])
				    corners.push_back(grid.point(p));
			    forSides(corners, [&](double length) { open.most = std::min(open.most, kMostOfEdge * length); });
		    }
		    for (const PointId p : faces[static_cast<int>(way.face.face)])
			    if (const Vec3 corner = grid.point(p); std::ranges::find(open.corners, corner) == open.corners.end())
				    open.corners.push_back(corner);
		    double ulp = std::numeric_limits<double>::epsilon();
		    if constexpr (requires { grid.coordinates(); })
			    if (!grid.coordinates().isDouble())
				    ulp = std::numeric_limits<float>::epsilon();
		    double greatest = 0.0;
		    for (const Vec3& corner : open.corners)
			    greatest = std::max({greatest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
		    forSides(open.corners, [&](double length) { open.edge = std::min(open.edge, length); });
		    open.tolerance = std::max(kOfEdge * open.edge, std::min(4.0 * ulp * greatest, kMostOfEdge * open.edge));
	    },
	    blocks.blocks[way.block].grid);
	return open;
}

void put(MessageWriter& to, const OpenFace& face)
{
	to.put(face.number);
	to.put(face.group);
	to.put(face.edge);
	to.put(face.tolerance);
	to.put(face.most);
	to.putAll(face.corners);
}

OpenFace takeOpenFace(MessageReader& from, int rank)
{
	OpenFace face{.rank = rank};
	face.number = from.get<std::uint32_t>();
	face.group = from.get<std::uint32_t>();
	face.edge = from.get<double>();
	face.tolerance = from.get<double>();
	face.most = from.get<double>();
	face.corners = from.getAll<Vec3>();
	return face;
}

/// Brings faces together in bins, and calls visit(a, b) for those of different ranks that share one: a is of the lower
/// rank. boxOf(face): no larger than a bin.
template <class BoxOf, class Visit>
void forPairs(Neighborhood& near, const SpaceBins& bins, const std::vector<OpenFace>& own, const BoxOf& boxOf,
              const Visit& visit)
{
	for (const OpenFace& face : own)
	{
		const Box box = boxOf(face);
		for (const auto& [bin, place] : bins.of(box.lo, box.hi))
		{
			MessageWriter& message = near.messageFor(place);
			message.put(bin);
			put(message, face);
		}
	}
	std::map<std::uint64_t, std::vector<OpenFace>> in_bin;
	const std::vector<Bytes> came = near.exchange();
	for (int rank = 0; rank < static_cast<int>(came.size()); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			const auto bin = reader.get<std::uint64_t>();
			in_bin[bin].push_back(takeOpenFace(reader, rank));
		}
	for (const auto& [bin, faces] : in_bin)
		for (std::size_t i = 0; i < faces.size(); ++i)
			for (std::size_t j = 0; j < i; ++j)
				if (faces[j].rank != faces[i].rank)
					visit(faces[j], faces[i]);
}

bool coincide(const OpenFace& a, const OpenFace& b)
{
	const double apart = std::min({std::max(a.tolerance, b.tolerance), a.most, b.most});
	const auto hasCornerOf = [&](const Vec3& p)
	{ return std::ranges::any_of(b.corners, [&](const Vec3& q) { return glm::length(p - q) <= apart; }); };
	return a.corners.size() == b.corners.size() && std::ranges::all_of(a.corners, hasCornerOf);
}

/// Whether a place lies on the fan of triangles about the center of a face.
bool liesOn(const Vec3& place, const OpenFace& face, double apart)
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

bool isPartOf(const OpenFace& small, const OpenFace& large)
{
	constexpr double kOfEdge = 1e-3;
	return std::ranges::all_of(small.corners,
	                           [&](const Vec3& corner) { return liesOn(corner, large, kOfEdge * small.edge); });
}

double greatestOf(Team& team, double own)
{
	sumOverAll(team, own, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	return own;
}

/// Links the groups whose faces lie on each other. Returns the faces that lie on none.
std::vector<OpenFace> linkGroups(Team& team, const std::vector<Box>& boxes, std::vector<OpenFace> own,
                                 std::vector<Link>& links)
{
	constexpr double kReach = 2.0; // of a tolerance: centers of faces whose corners are that near
	double side = 0.0;
	for (const OpenFace& face : own)
		side = std::max(side, 2.0 * kReach * face.tolerance);
	side = greatestOf(team, side);
	if (!(side > 0.0))
		return own;
	Neighborhood near(team, boxes, 2.0 * side);
	std::vector<std::pair<int, std::uint32_t>> matched;
	forPairs(
	    near, SpaceBins(side), own,
	    [](const OpenFace& face)
	    {
		    const Vec3 center = face.center();
		    return Box{center - kReach * face.tolerance, center + kReach * face.tolerance};
	    },
	    [&](const OpenFace& a, const OpenFace& b)
	    {
		    if (!coincide(a, b))
			    return;
		    links.push_back({a.rank, a.group, b.rank, b.group});
		    matched.emplace_back(a.rank, a.number);
		    matched.emplace_back(b.rank, b.number);
	    });
	for (const auto& [rank, number] : matched)
		near.messageFor(rank).put(number);
	std::vector<bool> is_matched(own.size());
	for (const Bytes& bytes : near.exchange())
		for (MessageReader reader(bytes); !reader.atEnd();)
			is_matched[reader.get<std::uint32_t>()] = true;
	std::erase_if(own, [&](const OpenFace& face) { return is_matched[face.number]; });
	return own;
}

bool hangs(Team& team, const std::vector<Box>& boxes, const std::vector<OpenFace>& unmatched)
{
	double side = 0.0;
	for (const OpenFace& face : unmatched)
		side = std::max(side, face.box().diagonal());
	side = greatestOf(team, side);
	if (!(side > 0.0))
		return false;
	Neighborhood near(team, boxes, 2.0 * side);
	bool found = false;
	forPairs(
	    near, SpaceBins(side), unmatched, [](const OpenFace& face) { return face.box(); },
	    [&](const OpenFace& a, const OpenFace& b) { found = found || isPartOf(a, b) || isPartOf(b, a); });
	return anyOf(team, found);
}

} // namespace

ReachedGroups reachedGroups(Team& team, const std::vector<Box>& boxes, const grid::BlockSet& blocks,
                            const contour::ContourParts& parts)
{
	std::vector<OpenFace> own;
	for (std::uint32_t i = 0; i < parts.ways_out.size(); ++i)
		own.push_back(faceOf(blocks, parts.ways_out[i], i));
	std::vector<Link> links;
	const std::vector<OpenFace> unmatched = linkGroups(team, boxes, std::move(own), links);
	ReachedGroups groups;
	groups.hangs = hangs(team, boxes, unmatched);
	std::vector<std::uint8_t> from_sheet(parts.group_count, 0);
	from_sheet[0] = 1;
	groups.reached = joinOverRanks(team, from_sheet, std::move(links)).marks;
	return groups;
}

} // namespace vp::session
