#include "ranks/join/hanging_borders.h"

#include "ranks/space_bins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vp::ranks
{

namespace
{

struct Side
{
	Vec3 from;
	Vec3 to;
};

struct Point
{
	Vec3 place;
	double near;
};

/// The sides of polygons that no other polygon of the mesh has.
std::vector<Side> loneSides(const mesh::SheetMesh& mesh)
{
	std::unordered_map<std::uint64_t, int> uses;
	const auto keyOf = [](std::uint32_t v, std::uint32_t w)
	{ return std::uint64_t(std::min(v, w)) << 32 | std::max(v, w); };
	const auto forSides = [&](const auto& visit)
	{
		for (std::size_t p = 0; p < mesh.polygons(); ++p)
		{
			std::uint32_t before = mesh.polygon(p).back();
			for (const std::uint32_t v : mesh.polygon(p))
				visit(std::exchange(before, v), v);
		}
	};
	forSides([&](std::uint32_t v, std::uint32_t w) { ++uses[keyOf(v, w)]; });
	std::vector<Side> sides;
	forSides(
	    [&](std::uint32_t v, std::uint32_t w)
	    {
		    if (uses[keyOf(v, w)] == 1)
			    sides.push_back({mesh.positions[v], mesh.positions[w]});
	    });
	return sides;
}

bool liesAmid(const Point& point, const Side& side)
{
	const Vec3 way = side.to - side.from;
	const double square = glm::dot(way, way);
	if (!(square > 0.0))
		return false;
	const double t = glm::dot(point.place - side.from, way) / square;
	const double end = 2.0 * point.near / std::sqrt(square);
	return t > end && t < 1.0 - end && glm::length(point.place - (side.from + t * way)) <= point.near;
}

/// The sides and points that the owner of a bin receives.
struct Bin
{
	std::vector<std::pair<int, Side>> sides; // with their ranks
	std::vector<std::pair<int, Point>> points;

	bool hasHanging() const
	{
		return std::ranges::any_of(points,
		                           [&](const auto& point)
		                           {
			                           return std::ranges::any_of(sides,
			                                                      [&](const auto& side) {
				                                                      return side.first != point.first &&
				                                                             liesAmid(point.second, side.second);
			                                                      });
		                           });
	}
};

} // namespace

bool hangsBetweenRanks(Team& team, const std::vector<Box>& boxes, const mesh::SheetMesh& mesh,
                       std::span<const RimVertex> rim)
{
	const std::vector<Side> sides = team.size() > 1 ? loneSides(mesh) : std::vector<Side>();
	double longest = 0.0;
	for (const Side& side : sides)
		longest = std::max(longest, glm::length(side.to - side.from));
	sumOverAll(team, longest, [](double& greatest, double other) { greatest = std::max(greatest, other); });
	if (!(longest > 0.0))
		return false;
	const SpaceBins bins(longest);                 // so each side is in a few
	Neighborhood near(team, boxes, 2.0 * longest); // the middle of a bin lies no farther from the sides in it
	const auto send = [&](const std::pair<std::uint64_t, Vec3>& bin, bool is_side, const auto& what)
	{
		MessageWriter& message = near.messageFor(bin.second);
		message.put(bin.first);
		message.put(is_side);
		message.put(what);
	};
	for (const Side& side : sides)
		for (const auto& bin : bins.of(side.from, side.to))
			send(bin, true, side);
	for (const RimVertex& vertex : rim)
		if (vertex.on_edge)
			send(bins.at(vertex.place), false, Point{vertex.place, vertex.near});
	std::map<std::uint64_t, Bin> found;
	const std::vector<Bytes> came = near.exchange();
	for (int rank = 0; rank < team.size(); ++rank)
		for (MessageReader reader(came[static_cast<std::size_t>(rank)]); !reader.atEnd();)
		{
			Bin& bin = found[reader.get<std::uint64_t>()];
			if (reader.get<bool>())
				bin.sides.emplace_back(rank, reader.get<Side>());
			else
				bin.points.emplace_back(rank, reader.get<Point>());
		}
	return anyOf(team, std::ranges::any_of(found, [](const auto& bin) { return bin.second.hasHanging(); }));
}

Error sizesDiffer(std::string_view option)
{
	return Error{
	    ErrorKind::input,
	    fmt::format("{}cells of different sizes meet between two processes; give each such group of blocks to one "
	                "of them by fewer processes, or use vprobe",
	                option.empty() ? "" : fmt::format("`{}`: ", option))};
}

} // namespace vp::ranks
