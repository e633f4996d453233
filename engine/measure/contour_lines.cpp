#include "measure/contour_lines.h"

#include <algorithm>

namespace vp::measure
{

namespace
{

// Names of places. A vertex is the edge from it to itself; what lies on an edge at the upper of two levels has the top
// bit, which ids of vertices leave free.
constexpr std::uint64_t kUpper = std::uint64_t(1) << 63;

std::uint64_t edgeName(std::uint32_t a, std::uint32_t b)
{
	return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

std::vector<NetEdge> rimOf(std::span<const PlaneTriangle> triangles, std::size_t vertices)
{
	std::vector<NetEdge> sides;
	for (const PlaneTriangle& t : triangles)
		for (int i = 0; i < 3; ++i)
			// Sides at the mean of a polygon's corners always cancel.
			if (t[i] < vertices && t[(i + 1) % 3] < vertices)
				sides.push_back({t[i], t[(i + 1) % 3]});
	return netEdges(std::move(sides));
}

// Places that agree are told once.
template <class PointOf>
PlaneLine lineOf(const std::vector<std::uint64_t>& names, const PointOf& pointOf)
{
	PlaneLine line;
	line.closed = names.size() > 2 && names.front() == names.back();
	for (const std::uint64_t name : names)
		if (const glm::dvec2 point = pointOf(name); line.points.empty() || point != line.points.back())
			line.points.push_back(point);
	if (line.closed && line.points.size() > 1 && line.points.front() == line.points.back())
		line.points.pop_back();
	return line;
}

} // namespace

struct Contours::Bounds
{
	double lo;
	double hi;

	int side(double value) const { return value < lo ? -1 : value < hi ? 0 : 1; }
};

Contours::Contours(const PlaneTriangles& triangles, std::vector<double> levels)
    : triangles_(triangles), levels_(std::move(levels)), steps_(levels_.size()),
      rim_(rimOf(triangles.triangles, triangles.vertices))
{
	for (const PlaneTriangle& t : triangles.triangles)
	{
		const double v[] = {triangles.values[t[0]], triangles.values[t[1]], triangles.values[t[2]]};
		const auto [low, high] = std::minmax({v[0], v[1], v[2]});
		const auto first = std::ranges::upper_bound(levels_, low);
		const auto last = std::upper_bound(first, levels_.end(), high);
		for (auto level = first; level != last; ++level)
		{
			// Around the part above: it is left through one side and entered again through another, and the line leads
			// from the one to the other.
			PlaneStep step{};
			for (int i = 0; i < 3; ++i)
			{
				const int next = (i + 1) % 3;
				if (v[i] >= *level && v[next] < *level)
					step.from = edgeName(t[i], t[next]);
				else if (v[i] < *level && v[next] >= *level)
					step.to = edgeName(t[i], t[next]);
			}
			steps_[static_cast<std::size_t>(level - levels_.begin())].push_back(step);
		}
	}
}

// The same from either side of the edge: reckoned from its lower end.
glm::dvec2 Contours::crossing(std::uint64_t edge, double level) const
{
	const auto a = static_cast<std::uint32_t>(edge >> 32);
	const auto b = static_cast<std::uint32_t>(edge);
	const double from = triangles_.values[a];
	const double to = triangles_.values[b];
	const double t = std::clamp((level - from) / (to - from), 0.0, 1.0);
	return triangles_.points[a] + t * (triangles_.points[b] - triangles_.points[a]);
}

std::vector<PlaneLine> Contours::lines(std::size_t level) const
{
	std::vector<PlaneLine> lines;
	for (const std::vector<std::uint64_t>& names : chained(steps_[level]))
	{
		PlaneLine line = lineOf(names, [&](std::uint64_t edge) { return crossing(edge, levels_[level]); });
		if (line.points.size() > 1)
			lines.push_back(std::move(line));
	}
	return lines;
}

// The part of a side of the rim within the bounds.
void Contours::addRim(const NetEdge& edge, const Bounds& bounds, std::vector<PlaneStep>& steps) const
{
	const int from = bounds.side(triangles_.values[edge.from]);
	const int to = bounds.side(triangles_.values[edge.to]);
	if (from == to && from != 0)
		return;
	const auto end = [&](int side, std::uint32_t vertex)
	{
		const std::uint64_t name = edgeName(edge.from, edge.to);
		return side == 0 ? edgeName(vertex, vertex) : side > 0 ? name | kUpper : name;
	};
	steps.push_back({end(from, edge.from), end(to, edge.to)});
}

std::vector<PlaneLine> Contours::area(std::size_t from, std::size_t to) const
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	const Bounds bounds{from == kNoLevel ? -kInfinity : levels_[from], to == kNoLevel ? kInfinity : levels_[to]};
	std::vector<PlaneStep> steps;
	if (from != kNoLevel)
		steps = steps_[from];
	if (to != kNoLevel)
		for (const PlaneStep& step : steps_[to])
			steps.push_back({step.to | kUpper, step.from | kUpper});
	for (const NetEdge& edge : rim_)
		addRim(edge, bounds, steps);

	std::vector<PlaneLine> outlines;
	for (const std::vector<std::uint64_t>& names : chained(std::move(steps)))
	{
		const auto pointOf = [&](std::uint64_t name)
		{
			const std::uint64_t edge = name & ~kUpper;
			if (edge >> 32 == (edge & 0xFFFFFFFFu))
				return triangles_.points[edge >> 32];
			return crossing(edge, name & kUpper ? bounds.hi : bounds.lo);
		};
		PlaneLine line = lineOf(names, pointOf);
		line.closed = true;
		if (line.points.size() > 2)
			outlines.push_back(std::move(line));
	}
	return outlines;
}

std::vector<PlaneLine> outlinesOf(const std::vector<glm::dvec2>& points, std::span<const PlaneTriangle> triangles)
{
	return linesOf(rimOf(triangles, points.size()), points);
}

} // namespace vp::measure
